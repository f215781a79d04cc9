#include "runtime/spray/surface/window.h"

#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/shapes.h"

namespace arelem::spray {

namespace {
using geometry::Vec2;

/// Along u a surface is looked at in so many places; the window is made wider by as much as it may
/// miss between them. The planes themselves cut exactly.
constexpr int places = 720;
constexpr double beyond = 0.01;

struct Stretch {
  double from = -HUGE_VAL, to = HUGE_VAL;
};

/// The stretch of a straight line, place + t step, on the kept side of all planes.
Stretch between(const std::vector<HalfSpace>& keep, const Vec3& place, const Vec3& step) {
  Stretch kept;
  for (const HalfSpace& side : keep) {
    const double slope = side.normal.dot(step);
    const double over = side.over(place);
    if (std::abs(slope) <= tolerance::nullDirection * step.norm()) {
      if (over < 0.0) {
        return {HUGE_VAL, -HUGE_VAL};
      }
    } else if (slope > 0.0) {
      kept.from = std::max(kept.from, -over / slope);
    } else {
      kept.to = std::min(kept.to, -over / slope);
    }
  }
  return kept;
}

/// Cuts a convex polygon of the plane's own coordinates.
std::vector<Vec2> cutOff(const Patch& patch,
                         const std::vector<Vec2>& polygon,
                         const HalfSpace& side) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const double overA = side.over(patch.at(a.x(), a.y()));
    const double overB = side.over(patch.at(b.x(), b.y()));
    if (overA >= 0.0) {
      kept.push_back(a);
    }
    if ((overA >= 0.0) != (overB >= 0.0)) {
      kept.push_back(a + overA / (overA - overB) * (b - a));
    }
  }
  return kept;
}

WindowBetween windowOfPlane(Patch& patch) {
  constexpr double far = 1e9;  // mm
  std::vector<Vec2> polygon = {{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (const HalfSpace& side : patch.keep) {
    polygon = cutOff(patch, polygon, side);
  }
  if (polygon.size() < 3) {
    return WindowBetween::empty;
  }
  Vec2 low = polygon[0];
  Vec2 high = polygon[0];
  for (const Vec2& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  if (std::max(high.maxCoeff(), -low.minCoeff()) > far / 2.0) {
    return WindowBetween::endless;
  }
  patch.u0 = low.x();
  patch.u1 = high.x();
  patch.v0 = low.y();
  patch.v1 = high.y();
  return WindowBetween::bounded;
}
}  // namespace

WindowBetween windowBetween(Patch& patch, double lowest, bool isPlane) {
  if (isPlane) {
    return windowOfPlane(patch);
  }
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (int i = 0; i <= places; ++i) {
    const double u = patch.u0 + (patch.u1 - patch.u0) * i / places;
    const Vec3 start = patch.at(u, 0.0);
    Stretch kept = between(patch.keep, start, patch.at(u, 1.0) - start);
    kept.from = std::max(kept.from, lowest);
    if (kept.to > kept.from) {
      low = std::min(low, kept.from);
      high = std::max(high, kept.to);
    }
  }
  if (!(high > low)) {
    return WindowBetween::empty;
  }
  if (!std::isfinite(low) || !std::isfinite(high)) {
    return WindowBetween::endless;
  }
  const double more = beyond * (high - low);
  patch.v0 = std::max(low - more, lowest);
  patch.v1 = high + more;
  return WindowBetween::bounded;
}

}  // namespace arelem::spray
