#pragma once
#include <cmath>

#include "runtime/motion/axis.h"

namespace arelem::motion {

/// A piece of path: a straight cut vector, with an axis that turns evenly from one end to the
/// other, or an arc about a vertical axis with the tool axis vertical too: seen along that axis it
/// is one of a circle, while both of its directions rise with a leaning part plane.
struct Segment {
  Vec3 from, direction;  ///< at the start; unit, of an arc seen along its axis
  double length = 0.0;
  Vec3 tangentFrom, tangentTo;   ///< of the true path at both ends
  Vec3 axisFrom, axisTo;         ///< unit
  bool turning = false;          ///< whether the axes differ
  Vec3 toCenter = Vec3::Zero();  ///< arc: from its start to its center
  double curvature = 0.0;        ///< arc: one over the radius, positive counterclockwise; else 0

  [[nodiscard]] bool isArc() const { return curvature != 0.0; }
  [[nodiscard]] Vec3 at(double along) const {
    if (!isArc()) {
      return from + along * direction;
    }
    const double angle = along * curvature;
    const double s = std::sin(angle);
    const double half = std::sin(0.5 * angle);
    return from + s / curvature * direction + 2.0 * half * half * toCenter;
  }
  [[nodiscard]] Vec3 axisAt(double along) const {
    return turning && length > 0.0
               ? Vec3(axisFrom + along / length * (axisTo - axisFrom)).normalized()
               : axisFrom;
  }
  [[nodiscard]] Vec3 spin() const {
    return turning ? motion::spin(axisFrom, axisTo, length) : Vec3(Vec3::Zero());
  }
  /// Tangent of the true path, not normalized between the ends of a chord.
  [[nodiscard]] Vec3 tangentAt(double along) const {
    if (isArc()) {
      const double angle = along * curvature;
      return std::cos(angle) * direction + std::sin(angle) * curvature * toCenter;
    }
    return length > 0.0 ? Vec3(tangentFrom + along / length * (tangentTo - tangentFrom))
                        : tangentFrom;
  }
};

}  // namespace arelem::motion
