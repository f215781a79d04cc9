#pragma once
#include <algorithm>
#include <cmath>

#include "runtime/tool/contact.h"
#include "runtime/tool/rounded.h"

/// A surface that does not change along a direction square to the tool axis sees the cutter by its
/// section across that direction: a rounded bottom, two sides and the upper rim, seen edge-on.
/// Private to runtime/tool.
namespace arelem::tool {

template <surface::Surface S>
class SectionProof {
 public:
  SectionProof(const S& s,
               double side,
               const Profile& cutter,
               const Vec3& te,
               const Vec3& axis,
               const typename S::Hint& hint)
      : surface_(s), side_(side), cutter_(cutter), te_(te), axis_(axis), hint_(hint) {}

  /// True where it is proven that no place of the cutter comes nearer than the contact `c`.
  [[nodiscard]] bool holds(const Contact& c) {
    const Vec3 along = surface::generatrix(surface_);
    if (along.isZero(0.0) || std::abs(along.dot(axis_)) > square || cutter_.alpha > 0.0 ||
        !isRounded(cutter_)) {
      return false;
    }
    gap_ = c.gap;
    across_ = axis_.cross(along);
    const ProfilePoint& from = cutter_.sideStart;
    const ProfilePoint& to = cutter_.sideEnd;
    const Place left = at(-cutter_.e, cutter_.f);
    const Place right = at(cutter_.e, cutter_.f);
    const double touching = (c.point + cutter_.r * c.normal - te_).dot(across_);
    const Place middle = at(std::clamp(touching, -cutter_.e, cutter_.e), cutter_.f);
    const Place leftTop = at(-to.rho, to.z);
    const Place rightTop = at(to.rho, to.z);
    return clears(left, middle, cutter_.r) && clears(middle, right, cutter_.r) &&
           clears(at(-from.rho, from.z), leftTop, 0.0) &&
           clears(at(from.rho, from.z), rightTop, 0.0) && clears(leftTop, rightTop, 0.0);
  }

 private:
  /// Sine of the angle up to which a direction counts as square to the axis.
  static constexpr double square = 1e-12;
  static constexpr double slack = 1e-9;
  static constexpr int deepest = 6;

  struct Place {
    Vec3 point;
    surface::Foot foot;
  };

  [[nodiscard]] Place at(double x, double z) { return at(te_ + x * across_ + z * axis_); }
  [[nodiscard]] Place at(const Vec3& point) { return {point, surface_.foot(point, hint_)}; }
  [[nodiscard]] double value(const Place& p) const { return side_ * p.foot.distance; }

  /// Whether the straight way from a to b, thickened by a ball, stays as far off as the contact.
  [[nodiscard]] bool clears(const Place& a, const Place& b, double ball, int depth = deepest) {
    const Vec3 half = 0.5 * (b.point - a.point);
    const double reach = half.norm();
    const double least = gap_ + ball - slack * (1.0 + reach);
    if (value(a) < least || value(b) < least) {
      return false;
    }
    if (std::max(value(a), value(b)) - 2.0 * reach >= least || reach <= slack) {
      return true;
    }
    if (halfClears(a, half, least) && halfClears(b, -half, least)) {
      return true;
    }
    if (depth == 0) {
      return false;
    }
    const Place middle = at(a.point + half);
    return clears(a, middle, ball, depth - 1) && clears(middle, b, ball, depth - 1);
  }

  /// The half next to p, by the slope there and the most that the distance bends towards the
  /// cutter.
  [[nodiscard]] bool halfClears(const Place& p, const Vec3& half, double least) const {
    const double reach = half.norm();
    const surface::Bends bends = surface_.bends(p.point, p.foot, reach);
    const double bend = std::min(0.0, side_ > 0.0 ? bends.low : -bends.high);
    const double rise = side_ * p.foot.normal.dot(half);
    return value(p) + rise + 0.5 * bend * reach * reach >= least;
  }

  const S& surface_;
  double side_;
  const Profile& cutter_;
  const Vec3& te_;
  const Vec3& axis_;
  typename S::Hint hint_;
  Vec3 across_ = Vec3::Zero();
  double gap_ = 0.0;
};

}  // namespace arelem::tool
