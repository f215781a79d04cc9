#pragma once
#include <cmath>

#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// Center, unit axis, radius of the axis circle and of the tube. Positive outside the tube.
///
/// A tube wider than the axis circle runs into itself about the axis. Then the surface is what is
/// seen of it from outside: it ends in two pits on the axis, the tips, which are the nearest for a
/// wedge of each half plane through the axis.
struct Torus {
  /// The way from the axis to the place of the last foot.
  struct Hint {
    Vec3 out = Vec3::UnitX();
    double rho = 0.0;
    bool tip = false;  ///< the foot is a tip
  };
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double major = 2.0;
  double minor = 1.0;

  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const {
    const Vec3 w = p - center;
    const double along = w.dot(axis);
    const Vec3 radial = w - along * axis;
    const double rho = radial.norm();
    const Vec3 out = rho > 0.0 ? Vec3(radial / rho) : Vec3(axis.unitOrthogonal());
    hint.rho = rho;
    hint.out = out;
    // Of the size of a part: std::hypot would take longer than all else here.
    const double across = rho - major;
    const double length = std::sqrt(across * across + along * along);
    hint.tip = across * minor < -major * length;
    if (hint.tip) {
      const Vec3 way = tip(along) - w;
      const double depth = way.norm();
      return {-depth, depth > 0.0 ? Vec3(way / depth) : out};
    }
    const Vec3 normal = length > 0.0 ? Vec3((across * out + along * axis) / length) : out;
    return {length - minor, normal};
  }
  /// The meridian's bend is 1/L, L the distance to the axis circle; the one about the axis is
  /// (rho - major)/(L rho), less than 1/L, and negative where rho < major. Where a tip is the
  /// nearest the bend is that of the distance to it, and without end amidst both.
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double within) const {
    const Vec3 w = p - center;
    const double rho = w.cross(axis).norm();
    const double along = std::abs(w.dot(axis));
    const bool spindle = minor > major;
    const double tube = (spindle ? std::hypot(rho - major, along) : foot.distance + minor) - within;
    const double nearest = rho - within;
    if (tube <= 0.0 || nearest <= 0.0) {
      return {};
    }
    const double inward = std::min(1.0, std::max(0.0, major - nearest) / tube);
    Bends b{-inward / nearest, 1.0 / tube};
    if (spindle && (rho - major) * tipHeight() + along * major <= within * minor) {
      b.low = std::min(b.low, bendsOfAnySet(foot.distance, within).low);
      b.high = along > within ? b.high : Bends{}.high;
    }
    return b;
  }
  [[nodiscard]] Vec3 turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
    if (hint.tip) {
      return (t - foot.normal.dot(t) * foot.normal) / foot.distance;
    }
    if (hint.rho <= 0.0) {
      return Vec3::Zero();
    }
    const Vec3 around = axis.cross(hint.out);
    const Vec3 aside = around.dot(t) * around;
    const Vec3 meridian = t - foot.normal.dot(t) * foot.normal - aside;
    return meridian / (foot.distance + minor) + foot.normal.dot(hint.out) / hint.rho * aside;
  }
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const {
    return t.dot(turn(p, foot, t, hint));
  }

 private:
  [[nodiscard]] double tipHeight() const { return std::sqrt((minor - major) * (minor + major)); }
  /// The tip on the side of a place so far along the axis, from the center.
  [[nodiscard]] Vec3 tip(double along) const { return std::copysign(tipHeight(), along) * axis; }
};

}  // namespace arelem::surface
