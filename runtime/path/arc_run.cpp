#include "runtime/path/arc_run.h"

#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::path {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double mostSweep = 1.95 * std::numbers::pi;
/// A flatter arc is a line to any machine: largest radius, part unit.
constexpr double largestRadius = 1e5;

Vec2 inPlane(const Vec3& p, int axis) {
  return {p((axis + 1) % 3), p((axis + 2) % 3)};
}

/// Center of the circle through three points; none when they are on a line.
std::optional<Vec2> circumcenter(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double twice = 2.0 * (u.x() * v.y() - u.y() * v.x());
  if (std::abs(twice) <= tolerance::rounding * u.norm() * v.norm()) {
    return std::nullopt;
  }
  const double p = u.squaredNorm();
  const double q = v.squaredNorm();
  return Vec2(a + Vec2(v.y() * p - u.y() * q, u.x() * q - v.x() * p) / twice);
}

}  // namespace

Vec3 ArcRun::at(double sweep) const {
  Vec3 on = center;
  on((axis + 1) % 3) += radius * std::cos(start + sweep);
  on((axis + 2) % 3) += radius * std::sin(start + sweep);
  on(axis) += riseOfARadian * sweep;
  return on;
}

std::optional<ArcRun> arcThrough(std::span<const Vec3> points,
                                 int axis,
                                 double off,
                                 std::vector<double>& sweeps) {
  const std::size_t n = points.size();
  if (n < 4) {
    return std::nullopt;
  }
  const auto middle = circumcenter(inPlane(points[0], axis), inPlane(points[n / 2], axis),
                                   inPlane(points[n - 1], axis));
  if (!middle) {
    return std::nullopt;
  }
  ArcRun run;
  run.axis = axis;
  run.center = points[0];
  run.center((axis + 1) % 3) = middle->x();
  run.center((axis + 2) % 3) = middle->y();
  const Vec2 first = inPlane(points[0], axis) - *middle;
  run.radius = first.norm();
  run.start = std::atan2(first.y(), first.x());
  if (!(run.radius > off) || run.radius > largestRadius) {
    return std::nullopt;
  }
  sweeps.assign(1, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const Vec2 a = inPlane(points[i - 1], axis) - *middle;
    const Vec2 b = inPlane(points[i], axis) - *middle;
    const double step = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    const bool sameWay = i == 1 || (step > 0.0) == (sweeps[1] > 0.0);
    const bool near =
        std::abs(b.norm() - run.radius) <= off && run.radius * (1.0 - std::cos(0.5 * step)) <= off;
    if (step == 0.0 || std::abs(step) > ArcRun::mostStep || !sameWay || !near ||
        std::abs(sweeps.back() + step) > mostSweep) {
      return std::nullopt;
    }
    sweeps.push_back(sweeps.back() + step);
  }
  run.riseOfARadian = (points[n - 1](axis) - points[0](axis)) / sweeps.back();
  for (std::size_t i = 1; i < n; ++i) {
    const double height = points[0](axis) + run.riseOfARadian * sweeps[i];
    if (std::hypot(points[i](axis) - height,
                   (inPlane(points[i], axis) - *middle).norm() - run.radius) > off) {
      return std::nullopt;
    }
  }
  return run;
}

bool isStraight(std::span<const Vec3> points, double off) {
  const Vec3 from = points.front();
  const Vec3 along = points.back() - from;
  const double length = along.norm();
  if (!(length > 0.0)) {
    return false;
  }
  double before = 0.0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double s = (points[i] - from).dot(along) / length;
    const double away = (points[i] - from - s / length * along).norm();
    if (!(s >= before && s <= length) || away > off) {
      return false;
    }
    before = s;
  }
  return true;
}

}  // namespace arelem::path
