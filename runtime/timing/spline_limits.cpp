#include "runtime/timing/spline_limits.h"

#include <algorithm>
#include <cmath>

namespace arelem::timing {

double curveSpeed(double curvature, double acceleration) {
  return curvature > 0.0 ? std::sqrt(acceleration / curvature)
                         : std::numeric_limits<double>::infinity();
}

double cornerSpeed(double cosine, double deviation, double acceleration, double shorter) {
  // Half the turn: a circle of radius r passes the corner at r (1 / cos(half) - 1) and touches the
  // legs at r tan(half).
  const double cosHalf = std::sqrt(std::clamp(0.5 * (1.0 + cosine), 0.0, 1.0));
  const double sinHalf = std::sqrt(std::clamp(0.5 * (1.0 - cosine), 0.0, 1.0));
  if (!(cosHalf < 1.0) || !(sinHalf > 0.0)) {
    return std::numeric_limits<double>::infinity();
  }
  const double byDeviation = deviation * cosHalf * (1.0 + cosHalf) / (sinHalf * sinHalf);
  const double byLength = 0.5 * shorter * cosHalf / sinHalf;
  return std::sqrt(acceleration * std::min(byDeviation, byLength));
}

void appendCurve(SpeedLimits& path,
                 const spline::CubicSpline& curve,
                 int perSpan,
                 double feed,
                 double acceleration) {
  appendSpans(path, curve, 0, curve.spans(), perSpan, feed, acceleration);
}

void appendSpans(SpeedLimits& path,
                 const spline::CubicSpline& curve,
                 std::size_t first,
                 std::size_t count,
                 int perSpan,
                 double feed,
                 double acceleration) {
  const spline::Bezier start = curve.piece(first);
  double before = start.curvature(start.begin);
  Vec3 last = start.at(start.begin);
  for (std::size_t span = first; span < first + count; ++span) {
    const spline::Bezier piece = curve.piece(span);
    const double step = (piece.end - piece.begin) / perSpan;
    for (int i = 1; i <= perSpan; ++i) {
      const double t = i == perSpan ? piece.end : piece.begin + i * step;
      const double now = piece.curvature(t);
      const double middle = piece.curvature(t - 0.5 * step);
      const double most = std::max({before, middle, now});
      const Vec3 at = piece.at(t);
      const Vec3 half = piece.at(t - 0.5 * step);
      path.lengths.push_back((half - last).norm() + (at - half).norm());
      path.speeds.push_back(std::min(feed, curveSpeed(most, acceleration)));
      path.corners.push_back(std::numeric_limits<double>::infinity());
      before = now;
      last = at;
    }
  }
}

}  // namespace arelem::timing
