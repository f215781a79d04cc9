#pragma once
#include <cmath>

#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// One nappe of a circular cone: vertex, unit axis pointing into the nappe, half angle. Positive
/// outside; behind the vertex the nearest point is the vertex itself.
struct Cone {
  /// The way from the axis to the place of the last foot.
  struct Hint {
    Vec3 out = Vec3::UnitX();
    double rho = 0.0;
    bool behind = false;  ///< the vertex
  };
  Vec3 vertex = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double cosHalf = 1.0;
  double sinHalf = 0.0;

  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const {
    const Vec3 w = p - vertex;
    const double along = w.dot(axis);
    const Vec3 radial = w - along * axis;
    const double rho = radial.norm();
    hint.rho = rho;
    hint.out = rho > 0.0 ? Vec3(radial / rho) : Vec3(axis.unitOrthogonal());
    hint.behind = along * cosHalf + rho * sinHalf < 0.0;
    if (hint.behind) {
      const double length = w.norm();
      return {length, w / length};
    }
    return {rho * cosHalf - along * sinHalf, cosHalf * hint.out - sinHalf * axis};
  }
  [[nodiscard]] Vec3 turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
    if (hint.behind) {
      return (t - foot.normal.dot(t) * foot.normal) / foot.distance;
    }
    if (hint.rho <= 0.0) {
      return Vec3::Zero();
    }
    const Vec3 around = axis.cross(hint.out);
    // Only turning about the axis changes the normal: H = cos(half)/rho * (e_phi e_phi^T).
    return cosHalf / hint.rho * around.dot(t) * around;
  }
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const {
    return t.dot(turn(p, foot, t, hint));
  }
  /// The solid is convex. Behind the vertex the bend is 1/|w| <= cos(half)/rho too.
  [[nodiscard]] Bends bends(const Vec3& p, const Foot&, double within) const {
    const double least = (p - vertex).cross(axis).norm() - within;
    return {0.0, least > 0.0 ? cosHalf / least : Bends{}.high};
  }
};

}  // namespace arelem::surface
