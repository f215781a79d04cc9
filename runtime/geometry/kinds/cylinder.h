#pragma once
#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// Infinite circular cylinder; CIRCLE is the vertical one. Positive outside.
struct Cylinder {
  using Hint = NoHint;
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 1.0;

  [[nodiscard]] Foot foot(const Vec3& p, Hint&) const {
    const Vec3 w = p - point;
    const Vec3 radial = w - w.dot(axis) * axis;
    const double length = radial.norm();
    return {length - radius, length > 0.0 ? Vec3(radial / length) : Vec3(axis.unitOrthogonal())};
  }
  [[nodiscard]] Vec3 turn(const Vec3&, const Foot& foot, const Vec3& t, Hint&) const {
    return (t - foot.normal.dot(t) * foot.normal - axis.dot(t) * axis) / (foot.distance + radius);
  }
  [[nodiscard]] double bend(const Vec3&, const Foot& foot, const Vec3& t, Hint&) const {
    const double along = foot.normal.dot(t);
    const double axial = axis.dot(t);
    return (t.squaredNorm() - along * along - axial * axial) / (foot.distance + radius);
  }
  [[nodiscard]] Bends bends(const Vec3&, const Foot& foot, double within) const {
    const double least = foot.distance + radius - within;
    return {0.0, least > 0.0 ? 1.0 / least : Bends{}.high};
  }
  [[nodiscard]] const Vec3& generatrix() const { return axis; }
};

}  // namespace arelem::surface
