#pragma once
#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// n . p = d with unit n; LINE is the vertical plane. Positive where n points.
struct Plane {
  using Hint = NoHint;
  Vec3 normal = Vec3::UnitZ();
  double offset = 0.0;

  [[nodiscard]] Foot foot(const Vec3& p, Hint&) const { return {normal.dot(p) - offset, normal}; }
  [[nodiscard]] double bend(const Vec3&, const Foot&, const Vec3&, Hint&) const { return 0.0; }
  [[nodiscard]] Bends bends(const Vec3&, const Foot&, double) const { return {0.0, 0.0}; }
};

}  // namespace arelem::surface
