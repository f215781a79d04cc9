#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "ir/cl/record.h"
#include "ir/space/vector.h"

namespace arelem::backend::ngc {

/// An arc or helix about a coordinate axis, less than half a turn. Lengths in mm.
struct Arc {
  int axis = 2;          ///< 0 x, 1 y, 2 z
  bool positive = true;  ///< turns with the right hand about the axis: G3
  Vec3 end = Vec3::Zero();
  Vec3 center = Vec3::Zero();  ///< in the plane of the start
  std::size_t points = 0;      ///< locations that it replaces
};

/// The longest arc from `start` through the first of `points` that lie on the round surface, no
/// farther from it than `tolerance`, with chords that leave it by no more than `band`. None when
/// not even two locations do, or the axis is no coordinate axis.
[[nodiscard]] std::optional<Arc> arcThrough(const cl::SurfaceValue& surface,
                                            const Vec3& start,
                                            std::span<const Vec3> points,
                                            double tolerance,
                                            double band);

}  // namespace arelem::backend::ngc
