#pragma once
#include <span>

#include "runtime/motion/settle.h"

namespace arelem::motion {

/// A position with the tool nearer to `start`, which is measured, than `found`, or any where that
/// is none, if one is found from places around; else `found`. The way that shrinks what is missed
/// leads past others: through the vertex of a cone to its far side, or along a plane of symmetry.
/// Where fewer than three conditions leave a choice, what is hardly nearer counts as the same
/// position.
[[nodiscard]] Settled nearer(const Settled& found,
                             const Settled& start,
                             AxisRule& axis,
                             std::span<const Wanted> wanted,
                             std::span<const Constraint> constraints);

}  // namespace arelem::motion
