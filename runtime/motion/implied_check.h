#pragma once
#include "runtime/motion/follow.h"

namespace arelem::motion {

/// The check surface that the motion at `index` takes from the next one (spec 4.8), or why there is
/// none. `relation` is the drive relation in force.
[[nodiscard]] Result<CheckGoal> impliedCheck(const std::vector<runtime::Action>& actions,
                                             std::size_t index,
                                             std::optional<Word> relation);

/// The check surfaces of the motion at `index`: those that it names, or the implied one.
[[nodiscard]] Result<std::vector<CheckGoal>> checkGoals(const std::vector<runtime::Action>& actions,
                                                        std::size_t index,
                                                        const runtime::Follow& follow,
                                                        std::optional<Word> relation);

}  // namespace arelem::motion
