#pragma once
#include <vector>

#include "runtime/motion/state.h"

namespace arelem::motion {

/// Where a startup leads.
struct Standing {
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  std::vector<Failure> warnings;
};

/// GO/ and OFFSET/: the tool position that meets one, two or three surfaces (spec 4.7). Does not
/// change the state.
[[nodiscard]] Result<Standing> startupPosition(const State& state, const runtime::Startup& startup);

}  // namespace arelem::motion
