#pragma once
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "ir/space/vector.h"

namespace arelem::path {

/// A circle about an axis parallel to a coordinate axis, and how the path rises along it.
struct ArcRun {
  int axis = 2;                ///< 0 x, 1 y, 2 z
  Vec3 center = Vec3::Zero();  ///< at the height of the first point
  double radius = 0.0;
  double riseOfARadian = 0.0;

  double start = 0.0;  ///< angle of the first point about the axis

  /// Chords that turn more are no approximation of an arc, radians.
  static constexpr double mostStep = std::numbers::pi / 3.0;

  /// The point of the arc that has turned by `sweep` from the first point.
  [[nodiscard]] Vec3 at(double sweep) const;
};

/// The arc through the first, middle and last point about the given axis, if all points are within
/// `off` of it, all chords within `off` of their arcs, and all turn one way, by less than a full
/// turn. `sweeps` gets the turn of each point from the first.
[[nodiscard]] std::optional<ArcRun> arcThrough(std::span<const Vec3> points,
                                               int axis,
                                               double off,
                                               std::vector<double>& sweeps);

/// Whether the points between lie within `off` of the segment from the first to the last, in order.
[[nodiscard]] bool isStraight(std::span<const Vec3> points, double off);

}  // namespace arelem::path
