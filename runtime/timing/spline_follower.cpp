#include "runtime/timing/spline_follower.h"

#include <algorithm>
#include <cmath>

namespace arelem::timing {

namespace {
constexpr int mostSteps = 30;
constexpr int samples = 4;
/// Steps below this share of the parameters are none.
constexpr double noStep = 1e-12;
}  // namespace

std::optional<SplineFollower> SplineFollower::of(std::span<const double> canon) {
  Result<spline::CubicSpline> curve = spline::CubicSpline::of(canon);
  return curve ? std::optional(SplineFollower(*std::move(curve))) : std::nullopt;
}

/// Newton's method on the foot of the place, from the parameter before; never back.
double SplineFollower::curvatureTo(const Vec3& place) {
  const double from = t_;
  const double all = curve_.end() - curve_.begin();
  for (int i = 0; i < mostSteps; ++i) {
    const auto d = curve_.derivatives(t_);
    const double square = d.first.squaredNorm();
    if (!(square > 0.0)) {
      break;
    }
    const double step = (place - d.point).dot(d.first) / square;
    const double next = std::clamp(t_ + step, from, curve_.end());
    const double moved = std::abs(next - t_);
    t_ = next;
    if (moved <= noStep * all) {
      break;
    }
  }
  double most = 0.0;
  for (int i = 0; i <= samples; ++i) {
    most = std::max(most, curve_.curvature(from + (t_ - from) * i / samples));
  }
  return most;
}

}  // namespace arelem::timing
