#pragma once
#include "runtime/motion/state.h"

namespace arelem::motion {

/// GO/ and OFFSET/: the tool end that meets one, two or three surfaces (spec 4.7). Does not change
/// the state.
[[nodiscard]] Result<Vec3> startupPosition(const State& state, const runtime::Startup& startup);

}  // namespace arelem::motion
