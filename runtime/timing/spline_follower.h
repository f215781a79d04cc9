#pragma once
#include <optional>

#include "runtime/spline/cubic.h"

namespace arelem::timing {

/// Goes along a path spline as the cut vectors do that follow it, and tells how much it curves
/// under each of them.
class SplineFollower {
 public:
  /// None for numbers that are no spline.
  [[nodiscard]] static std::optional<SplineFollower> of(std::span<const double> canon);

  /// Largest curvature, sampled, from the place before to the next one, a point of the curve.
  [[nodiscard]] double curvatureTo(const Vec3& place);

 private:
  explicit SplineFollower(spline::CubicSpline curve)
      : curve_(std::move(curve)), t_(curve_.begin()) {}

  spline::CubicSpline curve_;
  double t_;
};

}  // namespace arelem::timing
