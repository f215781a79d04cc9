#pragma once
#include <span>

#include "runtime/certify/guide.h"
#include "runtime/spline/cubic.h"

namespace arelem::certify {

/// Places along a path spline, one after the other.
class SplineWalk {
 public:
  SplineWalk(const spline::CubicSpline& curve, double slack);
  /// Whether this place is the end of the curve. Of a closed curve its start is none.
  [[nodiscard]] bool arrives(const Vec3& place);

 private:
  const spline::CubicSpline& curve_;
  Vec3 end_;
  double slack_;
  double t_;
};

/// Proves that a path and a path spline are nowhere farther apart than `allowed.outer`, each cut
/// vector against the part of the curve between the feet of its ends, by the hulls of that part.
/// path[0] is where the motion begins. The range of `result.verdict` is that of the distance.
[[nodiscard]] GuideResult proveAlongSpline(const spline::CubicSpline& curve,
                                           std::span<const Location> path,
                                           const Allowed& allowed);

}  // namespace arelem::certify
