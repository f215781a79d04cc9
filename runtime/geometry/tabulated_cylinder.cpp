#include "runtime/geometry/tabulated_cylinder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/geometry/roots.h"

namespace arelem::geometry {

void TabulatedCylinder::Interval::bound() {
  highest = 0.0;
  lowest = 0.0;
  // v' = 3a t^2 + 2b t + c
  const QuadraticRoots extremes = solveQuadratic(3.0 * a, b, c());
  for (int i = 0; i < extremes.count; ++i) {
    const double t = i == 0 ? extremes.first : extremes.second;
    if (t > 0.0 && t < length) {
      highest = std::max(highest, offset(t));
      lowest = std::min(lowest, offset(t));
    }
  }
}

CurvePoint TabulatedCylinder::Interval::at(double t) const {
  return {start + t * along + offset(t) * across(), along + slope(t) * across(),
          bend(t) * across()};
}

TabulatedCylinder TabulatedCylinder::of(std::span<const double> canon) {
  TabulatedCylinder result;
  for (int i = 0; i < 9; ++i) {
    result.frame(i / 3, i % 3) = canon[static_cast<std::size_t>(i) + 2];
  }
  const auto n = static_cast<std::size_t>(canon[0]);
  std::size_t at = 11;
  for (std::size_t i = 0; i < n; ++i, at += 7) {
    Interval interval;
    interval.start = {canon[at], canon[at + 1]};
    const Vec2 next(canon[at + 7], canon[at + 8]);
    interval.a = canon[at + 2];
    interval.b = canon[at + 3];
    interval.length = canon[at + 4];
    interval.along = (next - interval.start).normalized();
    interval.highest = canon[at + 5] * interval.length;
    interval.lowest = canon[at + 6] * interval.length;
    interval.extension = i == 0 || i + 1 == n;
    result.intervals.push_back(interval);
  }
  result.end = {canon[at], canon[at + 1]};
  return result;
}

Canon TabulatedCylinder::canon() const {
  const std::size_t n = intervals.size();
  Canon result{static_cast<double>(n), static_cast<double>(9 + 7 * n + 2)};
  for (int i = 0; i < 9; ++i) {
    result.push_back(frame(i / 3, i % 3));
  }
  for (const Interval& i : intervals) {
    result.insert(result.end(), {i.start.x(), i.start.y(), i.a, i.b, i.length, i.highest / i.length,
                                 i.lowest / i.length});
  }
  result.insert(result.end(), {end.x(), end.y()});
  return result;
}

namespace {
/// The place of one interval nearest to (x, y) of its chord frame: zeros of
/// (t - x) + (v(t) - y) v'(t), bracketed by sampling, then bisected with Newton steps.
Nearest nearestOf(const TabulatedCylinder::Interval& interval, double x, double y) {
  const auto derivative = [&](double t) {
    return (t - x) + (interval.offset(t) - y) * interval.slope(t);
  };
  Nearest best{0, 0.0, std::numeric_limits<double>::infinity()};
  const auto consider = [&](double t) {
    const double distance = std::hypot(t - x, interval.offset(t) - y);
    if (distance < best.distance) {
      best.t = t;
      best.distance = distance;
    }
  };
  consider(0.0);
  consider(interval.length);
  constexpr int samples = 16;  // the derivative has degree 5, so at most 5 sign changes
  double low = 0.0;
  for (int i = 1; i <= samples; ++i) {
    double high = interval.length * i / samples;
    if (derivative(low) <= 0.0 && derivative(high) >= 0.0) {
      double from = low;
      double to = high;
      for (int step = 0; step < 60 && to - from > 0.0; ++step) {
        const double middle = 0.5 * (from + to);
        (derivative(middle) <= 0.0 ? from : to) = middle;
      }
      consider(0.5 * (from + to));
    }
    low = high;
  }
  return best;
}
}  // namespace

Nearest nearestOn(const TabulatedCylinder& surface, const Vec2& place, bool withExtensions) {
  Nearest best{0, 0.0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < surface.intervals.size(); ++i) {
    const TabulatedCylinder::Interval& interval = surface.intervals[i];
    if (interval.extension && !withExtensions) {
      continue;
    }
    const Vec2 local = place - interval.start;
    const double x = local.dot(interval.along);
    const double y = local.dot(interval.across());
    const double dx = std::max({0.0, -x, x - interval.length});
    const double dy = std::max({0.0, interval.lowest - y, y - interval.highest});
    if (std::hypot(dx, dy) >= best.distance) {
      continue;
    }
    Nearest found = nearestOf(interval, x, y);
    found.interval = i;
    if (found.distance < best.distance) {
      best = found;
    }
  }
  return best;
}

}  // namespace arelem::geometry
