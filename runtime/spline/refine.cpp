// Knot insertion: the same curve from more control points.
#include <algorithm>

#include "ir/diag/curves.h"
#include "ir/diag/spline.h"
#include "runtime/spline/cubic.h"

namespace arelem::spline {

/// Each control point is the blossom of the curve at the three knots in its middle, so the points
/// of any finer knot vector are blossoms of the old pieces.
namespace {

class Blossom {
 public:
  /// `full` has three knots more on each side of the distinct ones.
  Blossom(std::span<const double> full, const CubicSpline& curve) : full_(full), curve_(curve) {}

  /// f(r, s, t) by the polar form of `span`.
  [[nodiscard]] Vec3 at(std::size_t span, double r, double s, double t) const {
    const double* k = &full_[span + 1];
    const auto p = [&](std::size_t i) -> const Vec3& {
      return curve_.control()[curve_.index(span, i)];
    };
    const Vec3 a = mix(p(0), p(1), k[0], k[3], r);
    const Vec3 b = mix(p(1), p(2), k[1], k[4], r);
    const Vec3 c = mix(p(2), p(3), k[2], k[5], r);
    return mix(mix(a, b, k[1], k[3], s), mix(b, c, k[2], k[4], s), k[2], k[3], t);
  }

 private:
  static Vec3 mix(const Vec3& a, const Vec3& b, double from, double to, double at) {
    const double w = (at - from) / (to - from);
    return (1.0 - w) * a + w * b;
  }
  std::span<const double> full_;
  const CubicSpline& curve_;
};

std::vector<double> withNeighbors(std::span<const double> knots, bool closed) {
  const std::size_t n = knots.size();
  const double period = knots[n - 1] - knots[0];
  std::vector<double> full;
  full.reserve(n + 6);
  for (std::size_t i = 3; i > 0; --i) {
    full.push_back(closed ? knots[n - 1 - i] - period : knots[0]);
  }
  full.insert(full.end(), knots.begin(), knots.end());
  for (std::size_t i = 1; i <= 3; ++i) {
    full.push_back(closed ? knots[i] + period : knots[n - 1]);
  }
  return full;
}

/// The curve over `knots`, which hold all of its own.
CubicSpline over(const CubicSpline& curve, const std::vector<double>& knots) {
  const bool closed = curve.closed();
  const std::vector<double> old = withNeighbors(curve.knots(), closed);
  const std::vector<double> full = withNeighbors(knots, closed);
  const std::size_t m = closed ? knots.size() - 1 : knots.size() + 2;
  const Blossom blossom(old, curve);
  std::vector<Vec3> control(m);
  std::size_t span = 0;
  for (std::size_t i = 0; i < m; ++i) {
    // A span of the old curve whose polar form holds at the knots i+1, i+2, i+3: the one that the
    // middle knot begins, taken at the right end as the last one.
    const double middle = full[i + 2];
    if (closed && middle < curve.begin()) {
      // The first control points of a closed curve lie before its first knot: one period later.
      const double period = curve.end() - curve.begin();
      const auto distinct = curve.knots();
      const auto after = std::upper_bound(distinct.begin(), distinct.end(), middle + period);
      const auto late = static_cast<std::size_t>(after - distinct.begin()) - 1;
      control[i] = blossom.at(std::min(late, curve.spans() - 1), full[i + 1] + period,
                              full[i + 2] + period, full[i + 3] + period);
      continue;
    }
    while (span + 1 < curve.spans() && old[span + 4] <= middle) {
      ++span;
    }
    control[i] = blossom.at(span, full[i + 1], full[i + 2], full[i + 3]);
  }
  Result<CubicSpline> made = CubicSpline::make(std::move(control), knots, closed);
  return made ? *std::move(made) : curve;
}

}  // namespace

Result<CubicSpline> CubicSpline::withKnot(double t) const {
  const auto distinct = knots();
  const auto after = std::upper_bound(distinct.begin(), distinct.end(), t);
  if (!(t >= distinct.front() && t <= distinct.back())) {
    return fail(diag::SplineParameter, t, distinct.front(), distinct.back());
  }
  if (*(after - 1) == t) {
    return fail(diag::SplineKnotThere, t);
  }
  std::vector<double> finer(distinct.begin(), after);
  finer.push_back(t);
  finer.insert(finer.end(), after, distinct.end());
  return over(*this, finer);
}

CubicSpline CubicSpline::refined() const {
  return refined(std::vector<bool>(spans(), true));
}

CubicSpline CubicSpline::refined(const std::vector<bool>& marked) const {
  const auto distinct = knots();
  std::vector<double> finer;
  finer.reserve(2 * distinct.size());
  for (std::size_t i = 0; i + 1 < distinct.size(); ++i) {
    const double middle = 0.5 * (distinct[i] + distinct[i + 1]);
    finer.push_back(distinct[i]);
    if (marked[i] && middle > distinct[i] && middle < distinct[i + 1]) {
      finer.push_back(middle);
    }
  }
  finer.push_back(distinct.back());
  return over(*this, finer);
}

}  // namespace arelem::spline
