#pragma once
#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// Positive outside. At the center the normal is +z.
struct Sphere {
  using Hint = NoHint;
  Vec3 center = Vec3::Zero();
  double radius = 1.0;

  [[nodiscard]] Foot foot(const Vec3& p, Hint&) const {
    const Vec3 w = p - center;
    const double length = w.norm();
    return {length - radius, length > 0.0 ? Vec3(w / length) : Vec3(Vec3::UnitZ())};
  }
  [[nodiscard]] Vec3 turn(const Vec3&, const Foot& foot, const Vec3& t, Hint&) const {
    return (t - foot.normal.dot(t) * foot.normal) / (foot.distance + radius);
  }
  [[nodiscard]] double bend(const Vec3&, const Foot& foot, const Vec3& t, Hint&) const {
    const double along = foot.normal.dot(t);
    return (t.squaredNorm() - along * along) / (foot.distance + radius);
  }
  [[nodiscard]] Bends bends(const Vec3&, const Foot& foot, double within) const {
    const double least = foot.distance + radius - within;
    return {0.0, least > 0.0 ? 1.0 / least : Bends{}.high};
  }
};

}  // namespace arelem::surface
