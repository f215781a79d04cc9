#include "app/view/curves.h"

#include <algorithm>

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
}  // namespace

backend::Curves curvesOf(const Entity& entity) {
  switch (entity.type) {
    case EntityType::pathSpline:
      return splineOf(entity);
    case EntityType::region:
      return loopsOf(entity);
    default:
      return {};
  }
}

}  // namespace arelem::app
