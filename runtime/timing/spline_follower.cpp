#include "runtime/timing/spline_follower.h"

#include <algorithm>
#include <cmath>

namespace arelem::timing {

namespace {
constexpr int samples = 4;
}  // namespace

std::optional<SplineFollower> SplineFollower::of(std::span<const double> canon) {
  Result<spline::CubicSpline> curve = spline::CubicSpline::of(canon);
  return curve ? std::optional(SplineFollower(*std::move(curve))) : std::nullopt;
}

double SplineFollower::curvatureTo(const Vec3& place) {
  const double from = t_;
  t_ = curve_.footAhead(place, from);
  double most = 0.0;
  for (int i = 0; i <= samples; ++i) {
    most = std::max(most, curve_.curvature(from + (t_ - from) * i / samples));
  }
  return most;
}

}  // namespace arelem::timing
