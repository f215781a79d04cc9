#pragma once
#include <cstdint>

#include "runtime/motion/stop.h"

namespace arelem::motion {

/// An arc divided evenly (spec 4.8, rule of the plane route): the vertices stand on the band's
/// larger radius at the odd half steps, then the exact end follows.
struct ArcPlan {
  double radius = 0.0;          ///< of the vertices
  double halfStep = 0.0;        ///< radians, signed
  std::uint64_t halfSteps = 2;  ///< even
  double driveGap = 0.0;        ///< at the vertices
};

/// The plane route along a circle: the stop is found on the arc itself, not on chords.
class ArcRoute {
 public:
  explicit ArcRoute(Course& course);

  /// The first stop within so many turns.
  [[nodiscard]] std::optional<Found> findStop(StopFinder& stops, double turns);
  /// The even division of the arc up to `end`, where findStop found it.
  [[nodiscard]] ArcPlan plan(const PathPoint& end) const;
  /// Calls `put` with every vertex of the plan, in order, until it returns false.
  template <class Put>
  void forVertices(const ArcPlan& plan, Put put) const {
    const double stepCosine = std::cos(2.0 * plan.halfStep);
    const double stepSine = std::sin(2.0 * plan.halfStep);
    double c = 0.0, s = 0.0;
    for (std::uint64_t k = 1; k < plan.halfSteps; k += 2) {
      // Turned from vertex to vertex, and anew now and then against the growth of rounding.
      if ((k & renewMask) == 1) {
        const double angle = startAngle_ + static_cast<double>(k) * plan.halfStep;
        c = std::cos(angle);
        s = std::sin(angle);
      } else {
        const double next = c * stepCosine - s * stepSine;
        s = s * stepCosine + c * stepSine;
        c = next;
      }
      if (!put(onPart({center_.x() + plan.radius * c, center_.y() + plan.radius * s}))) {
        return;
      }
    }
  }

 private:
  static constexpr std::uint64_t renewMask = 63;

  [[nodiscard]] Segment piece(double along, double length) const;
  /// The tool end on the part plane above or below a place.
  [[nodiscard]] Vec3 onPart(const Eigen::Vector2d& p) const {
    return {p.x(), p.y(), partHeight_ + partSlope_.dot(p)};
  }
  /// A level direction, lifted into the part plane.
  [[nodiscard]] Vec3 alongPart(const Eigen::Vector2d& v) const {
    return {v.x(), v.y(), partSlope_.dot(v)};
  }

  Course& course_;
  Eigen::Vector2d center_;
  double startRadius_ = 0.0, startAngle_ = 0.0;
  double outward_ = 1.0;  ///< +1 with the tool outside the circle
  double radius_ = 0.0;   ///< of the tool end at rest
  double sense_ = 1.0;    ///< +1 counterclockwise
  double found_ = 0.0;    ///< length of the arc up to the stop, roughly
  Eigen::Vector2d partSlope_;
  double partHeight_ = 0.0;
};

}  // namespace arelem::motion
