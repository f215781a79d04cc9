#pragma once
#include <string>
#include <vector>

#include "backend/joints/kinematics.h"

namespace arelem::joints {

/// How much slower an arm must go along the knots to keep the speeds and accelerations of its
/// joints, for messages: a factor on all speeds, `rapid` among them, found by planning the way
/// again. Ramps and corners have the machine's acceleration whatever the speed: where a larger
/// factor does with another `acceleration`, that is told too. Figures are rounded down.
[[nodiscard]] std::string slowerThatDoes(const Arm& arm,
                                         const std::vector<Knot>& knots,
                                         const robot::Machine& machine);

}  // namespace arelem::joints
