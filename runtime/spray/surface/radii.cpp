#include "runtime/spray/surface/radii.h"

#include <algorithm>
#include <cmath>

#include "ir/space/spray_tolerance.h"
#include "runtime/spray/outline.h"

namespace arelem::spray {

namespace {
constexpr int samples = 64;  // of a parameter

/// Two directions at a place, in shares of the ranges of u and v.
struct Ways {
  Vec2 along = Vec2::UnitX();
  Vec2 across = Vec2::UnitY();
};

/// The surface about a place, so far inside the patch that differences stay on it.
class Spot {
 public:
  Spot(const Patch& patch, double u, double v) : patch_(patch) {
    const auto inside = [](double value, double from, double to) {
      const double h = tolerance::curvatureStep * (to - from);
      return std::clamp(value, from + h, to - h);
    };
    u_ = inside(u, patch.u0, patch.u1);
    v_ = inside(v, patch.v0, patch.v1);
    normal_ = patch.normal(u_, v_);
  }

  /// Of the section of a plane, and on the surface square to it; none where they are alike.
  [[nodiscard]] std::optional<Ways> waysOf(const PlaneNormal& planes) const {
    const Vec3 plane = planes(at(Vec2::Zero()));
    const Vec3 line = normal_.cross(plane);
    if (line.norm() < tolerance::leastLean) {
      return std::nullopt;
    }
    const Vec3 alongU = at(Vec2::UnitX()) - at(-Vec2::UnitX());
    const Vec3 alongV = at(Vec2::UnitY()) - at(-Vec2::UnitY());
    const auto squareTo = [&](const Vec3& n) { return Vec2(n.dot(alongV), -n.dot(alongU)); };
    const Ways ways = {squareTo(plane), squareTo(line)};
    if (!(ways.along.norm() > 0.0 && ways.across.norm() > 0.0)) {
      return std::nullopt;
    }
    return Ways{ways.along.normalized(), ways.across.normalized()};
  }

  /// The normal curvature, 1/mm, positive where the surface bends away from the normal.
  [[nodiscard]] double curvature(const Vec2& way) const {
    const Vec3 first = (at(way) - at(-way)) / 2.0;
    const Vec3 second = at(way) - 2.0 * at(Vec2::Zero()) + at(-way);
    const double square = first.squaredNorm();
    return square > 0.0 ? -second.dot(normal_) / square : 0.0;
  }

 private:
  /// A step of the differences away.
  [[nodiscard]] Vec3 at(const Vec2& way) const {
    constexpr double h = tolerance::curvatureStep;
    return patch_.at(u_ + h * way.x() * (patch_.u1 - patch_.u0),
                     v_ + h * way.y() * (patch_.v1 - patch_.v0));
  }

  const Patch& patch_;
  double u_ = 0.0, v_ = 0.0;
  Vec3 normal_ = Vec3::UnitZ();
};
}  // namespace

Radii smallestRadii(const Patch& patch) {
  return smallestRadii(patch, nullptr);
}

Radii smallestRadii(const Patch& patch, const PlaneNormal& planes) {
  double along = 0.0;
  double across = 0.0;
  double hollow = 0.0;
  const auto between = [](double from, double to, int i) {
    const double share =
        std::clamp(i / double{samples}, tolerance::rimMargin, 1.0 - tolerance::rimMargin);
    return from + share * (to - from);
  };
  for (int i = 0; i <= samples; ++i) {
    for (int k = 0; k <= samples; ++k) {
      const double u = between(patch.u0, patch.u1, i);
      const double v = between(patch.v0, patch.v1, k);
      if (!patch.keeps(u, v)) {
        continue;
      }
      const Spot spot(patch, u, v);
      const Ways own;
      hollow = std::max({hollow, -spot.curvature(own.along), -spot.curvature(own.across)});
      if (const std::optional<Ways> ways = planes ? spot.waysOf(planes) : std::optional(own)) {
        const double first = spot.curvature(ways->along);
        const double second = spot.curvature(ways->across);
        along = std::max(along, std::abs(first));
        across = std::max(across, std::abs(second));
        hollow = std::max({hollow, -first, -second});
      }
    }
  }
  const auto radius = [](double curvature) {
    return curvature > tolerance::flat ? std::optional(1.0 / curvature) : std::nullopt;
  };
  return {radius(along), radius(across), radius(hollow)};
}

}  // namespace arelem::spray
