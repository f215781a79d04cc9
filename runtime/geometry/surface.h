#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

#include "ir/space/vector.h"

/// Surfaces as motion sees them: signed distance fields.
///
/// Convention: `distance` is positive on the side to which `normal` points, and |grad distance| =
/// 1, so the nearest point of the surface is p - distance * normal. The distance is 1-Lipschitz in
/// p; checks and certificates build on that.
namespace arelem::surface {

struct Foot {
  double distance = 0.0;  ///< part unit
  Vec3 normal = Vec3::UnitZ();
};

/// Bounds of t . H t for all unit t, where H is the Hessian of the distance: how fast the distance
/// can bend away from its tangent. Infinite where there is no bound.
struct Bends {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// A warm start for kinds that need none.
struct NoHint {};

/// What a kind of surface must offer. `Hint` remembers where the last foot was; a query near the
/// last one then costs little. `bend` is t . H t with H the Hessian of the distance at p: the
/// normal curvature of the parallel surface through p along t, positive where the surface bends
/// away from the positive side. `bends` bounds it for all places within `radius` of p: proofs about
/// whole cut vectors are made of it. Its foot is that of p.
template <class S>
concept Surface = requires(const S& s,
                           typename S::Hint& hint,
                           const Vec3& p,
                           const Vec3& t,
                           const Foot& foot,
                           double radius) {
  { s.foot(p, hint) } -> std::same_as<Foot>;
  { s.bend(p, foot, t, hint) } -> std::convertible_to<double>;
  { s.bends(p, foot, radius) } -> std::same_as<Bends>;
};

/// Kinds with a closed form of the whole Hessian: `turn` is H t, the change of the normal along t.
/// Like `bend` it is asked for after the foot of p, with the hint that came from there.
/// Contacts are found with fewer looks at the surface then.
template <class S>
concept Turning = Surface<S> &&
    requires(const S& s, typename S::Hint& hint, const Vec3& p, const Vec3& t, const Foot& foot) {
  { s.turn(p, foot, t, hint) } -> std::same_as<Vec3>;
};

/// The same where the hint of the foot is at hand: kinds that would search for it need not.
template <Surface S>
[[nodiscard]] Bends bendsOf(
    const S& s, const Vec3& p, const Foot& foot, double radius, const typename S::Hint& hint) {
  if constexpr (requires { s.bends(p, foot, radius, hint); }) {
    return s.bends(p, foot, radius, hint);
  } else {
    return s.bends(p, foot, radius);
  }
}

/// What holds for the distance to any set of points: at distance d from it, it bends by at most 1/d
/// away from the set.
[[nodiscard]] inline Bends bendsOfAnySet(double distance, double radius) {
  Bends b;
  const double least = std::abs(distance) - radius;
  if (least > 0.0) {
    (distance > 0.0 ? b.high : b.low) = (distance > 0.0 ? 1.0 : -1.0) / least;
  }
  return b;
}
/// The narrower of two bounds at each end.
[[nodiscard]] inline Bends both(const Bends& a, const Bends& b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}
/// Bends of the distance within `radius` of a place at `distance` where the surface's own normal
/// curvatures (positive where it bends away from the positive side) lie in `curvature`. `single`:
/// no place there has two feet; else only the bend away from the surface is bounded.
[[nodiscard]] Bends bendsOfCurvature(const Bends& curvature,
                                     double distance,
                                     double radius,
                                     bool single);

}  // namespace arelem::surface
