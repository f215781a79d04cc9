#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/certify/body_search.h"

namespace arelem::certify {

/// Proof that no place of a circle is nearer to a surface than some gap: branch and bound over the
/// angle. At the chord 2 rho sin(x / 2) from a place of the circle its distance is at least
/// d + n . (y - y0) + low (2 rho sin(x / 2))^2 / 2: a sum of cosine and sine of x, the least of
/// which has a closed form. Where the circle lies in a hollow of nearly its own radius, the turn of
/// the circle and the bend of the distance cancel there, and what is left is of third order.
template <surface::Surface S>
class RimSearch {
 public:
  RimSearch(const S& surface, const Relation& relation)
      : surface_(surface), side_(relation.side), thick_(relation.thick) {}

  /// Whether the gap of balls of radius `ball` about the places of the circle is at least `aim`.
  /// Ends at the first gap below it, or when `budget` places were measured; `low` holds always.
  BodyResult run(
      const Vec3& center, const Vec3& axis, double rho, double ball, double aim, int budget) {
    BodyResult result;
    result.low = unbounded;
    e1_ = axis.unitOrthogonal();
    e2_ = axis.cross(e1_);
    arcs_.clear();
    arcs_.push_back({{}, rho > 0.0 ? Turn{std::numbers::pi, -1.0, 0.0} : Turn{}, -unbounded});
    while (!arcs_.empty()) {
      const Arc arc = arcs_.back();
      arcs_.pop_back();
      const double below = std::max(arc.low, look(arc, center, rho, ball, aim, result));
      if (below >= aim) {
        result.low = std::min(result.low, below);
        continue;
      }
      if (result.sample < aim || result.measured > budget || !(arc.half.radians > narrowest)) {
        for (const Arc& left : arcs_) {
          result.low = std::min(result.low, left.low);
        }
        result.low = std::min(result.low, below);
        return result;
      }
      const Turn half = arc.half.half();
      arcs_.push_back({arc.middle.plus(half, -1.0), half, below});
      arcs_.push_back({arc.middle.plus(half, 1.0), half, below});
    }
    result.proven = true;
    return result;
  }

 private:
  /// Parts of the circle that are not halved any more. Radians.
  static constexpr double narrowest = 1e-9;

  struct Arc {
    Turn middle, half;
    double low;  ///< no gap is below
  };

  /// Lower bound over an arc, from the place in its middle.
  double look(
      const Arc& arc, const Vec3& center, double rho, double ball, double aim, BodyResult& result) {
    const Vec3 radial = arc.middle.cosine * e1_ + arc.middle.sine * e2_;
    const Vec3 place = center + rho * radial;
    const surface::Foot foot = surface_.foot(place, hint_);
    const double gap = side_ * foot.distance - ball - thick_;
    ++result.measured;
    result.note(gap, 0.0, place - ball * side_ * foot.normal);
    const double away = 2.0 * rho * arc.half.half().sine;
    double best = gap - away;
    if (best >= aim || away == 0.0) {
      return best;
    }
    const surface::Bends bends = surface::bendsOf(surface_, place, foot, away, hint_);
    const double low = side_ > 0.0 ? bends.low : -bends.high;
    if (std::isfinite(low)) {
      const Vec3 around = arc.middle.cosine * e2_ - arc.middle.sine * e1_;
      const double inwards = -side_ * foot.normal.dot(radial);
      const double along = side_ * foot.normal.dot(around);
      best = std::max(best, gap + rho * leastOfTurn(inwards + low * rho, along, arc.half));
    }
    return best;
  }

  const S& surface_;
  double side_, thick_;
  typename S::Hint hint_{};
  Vec3 e1_ = Vec3::UnitX(), e2_ = Vec3::UnitY();
  std::vector<Arc> arcs_;
};

}  // namespace arelem::certify
