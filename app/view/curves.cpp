#include "app/view/curves.h"

#include <algorithm>
#include <numbers>
#include <span>

#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/region/region.h"
#include "runtime/spline/cubic.h"

namespace arelem::app {

namespace {
constexpr double fineness = 2e-4;  // of a curve's size

backend::Curves splineOf(const Entity& entity) {
  const auto curve = spline::CubicSpline::of(entity.canon);
  if (!curve) {
    return {};
  }
  Vec3 low = curve->control().front();
  Vec3 high = low;
  for (const Vec3& p : curve->control()) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  return size > 0.0 ? backend::Curves{spline::chordPoints(*curve, fineness * size)}
                    : backend::Curves{};
}

backend::Curves loopsOf(const Entity& entity) {
  if (!region::Region::readable(entity.canon)) {
    return {};
  }
  backend::Curves loops = region::Region::of(entity.canon).loops;
  for (auto& loop : loops) {
    if (!loop.empty()) {
      loop.push_back(loop.front());
    }
  }
  return loops;
}
/// A turned curve where it begins and ends and between, and the circles of some of its points.
backend::Curves revolvedOf(const Entity& entity) {
  constexpr std::size_t head = 8;  // numbers before those of the curve
  constexpr int meridians = 8, rings = 4, inEachInterval = 8, inEachRing = 64;
  const std::vector<double>& c = entity.canon;
  if (c.size() <= head) {
    return {};
  }
  const auto curve = geometry::TabulatedCylinder::of({c.begin() + head, c.end()});
  std::vector<Vec3> points;
  for (const auto& interval : curve.intervals) {
    if (interval.extension) {
      continue;
    }
    for (int k = points.empty() ? 0 : 1; k <= inEachInterval; ++k) {
      points.push_back(curve.inSpace(interval.at(interval.length * k / inEachInterval).place));
    }
  }
  if (points.empty()) {
    return {};
  }
  const Vec3 center(c[0], c[1], c[2]), axis(c[3], c[4], c[5]);
  const auto turned = [&](const Vec3& p, double share) {
    const double angle = (c[6] + share * (c[7] - c[6])) * std::numbers::pi / 180.0;
    return Vec3(center + Eigen::AngleAxisd(angle, axis) * (p - center));
  };
  backend::Curves curves;
  for (int k = 0; k <= meridians; ++k) {
    std::vector<Vec3>& line = curves.emplace_back();
    std::transform(points.begin(), points.end(), std::back_inserter(line),
                   [&](const Vec3& p) { return turned(p, 1.0 * k / meridians); });
  }
  for (int k = 0; k <= rings; ++k) {
    const Vec3& p = points[(points.size() - 1) * static_cast<std::size_t>(k) / rings];
    std::vector<Vec3>& ring = curves.emplace_back();
    for (int i = 0; i <= inEachRing; ++i) {
      ring.push_back(turned(p, 1.0 * i / inEachRing));
    }
  }
  return curves;
}
}  // namespace

backend::Curves curvesOf(const Entity& entity) {
  switch (entity.type) {
    case EntityType::pathSpline:
      return splineOf(entity);
    case EntityType::region:
      return loopsOf(entity);
    case EntityType::revolved:
      return revolvedOf(entity);
    default:
      return {};
  }
}

}  // namespace arelem::app
