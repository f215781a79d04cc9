#pragma once
#include <concepts>

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

/// A warm start for kinds that need none.
struct NoHint {};

/// What a kind of surface must offer. `Hint` remembers where the last foot was; a query near the
/// last one then costs little. `bend` is t . H t with H the Hessian of the distance at p: the
/// normal curvature of the parallel surface through p along t, positive where the surface bends
/// away from the positive side.
template <class S>
concept Surface =
    requires(const S& s, typename S::Hint& hint, const Vec3& p, const Vec3& t, const Foot& foot) {
  { s.foot(p, hint) } -> std::same_as<Foot>;
  { s.bend(p, foot, t, hint) } -> std::convertible_to<double>;
};

}  // namespace arelem::surface
