#pragma once
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "ir/space/vector.h"

namespace arelem::spray {

/// One side of a plane: what lies over it is kept. mm.
struct HalfSpace {
  Vec3 normal = Vec3::UnitZ();
  double level = 0.0;
  [[nodiscard]] double over(const Vec3& place) const { return normal.dot(place) - level; }
};

/// A piece of a surface by two parameters, in mm. What u and v are: of a plane its own x and y; of
/// a cylinder, cone, sphere, torus and surface of revolution u is the angle about the axis in
/// degrees; v is the length along the axis (cylinder), from the vertex (cone), the latitude
/// (sphere), the angle about the tube (torus), the length along the curve (surface of revolution).
/// Of a tabulated cylinder u is the length along the curve and v that along the generatrix; of a
/// ruled surface u runs along the curves and v from the first to the second, both 0 to 1.
struct Patch {
  std::function<Vec3(double u, double v)> at;
  /// How long the second derivatives of a place are at most, where |v| is at most `most`; empty
  /// where that is not known.
  struct Bend {
    double uu = 0.0, uv = 0.0, vv = 0.0;
  };
  std::function<Bend(double most)> bend;
  double u0 = 0.0, u1 = 1.0, v0 = 0.0, v1 = 1.0;
  bool flipped = false;         ///< the gun stands on the other side
  std::vector<HalfSpace> keep;  ///< the piece ends at these planes too

  /// Whether a place of the parameters is on the kept side of all planes.
  [[nodiscard]] bool keeps(double u, double v) const {
    const Vec3 place = keep.empty() ? Vec3(Vec3::Zero()) : at(u, v);
    return std::all_of(keep.begin(), keep.end(),
                       [&place](const HalfSpace& side) { return side.over(place) >= 0.0; });
  }

  /// Unit normal r_u x r_v, turned round where flipped.
  [[nodiscard]] Vec3 normal(double u, double v) const;
};

/// Bounds of the parameters in the units of the part program (lengths) and degrees.
struct Limits4 {
  double u0 = 0.0, u1 = 0.0, v0 = 0.0, v1 = 0.0;
};
/// Where a surface ends: by its parameters, by planes (mm), or both.
struct Limits {
  std::optional<Limits4> ranges;
  std::vector<HalfSpace> keep;
};

/// The patch of a surface. A plane, a cylinder, a cone and a tabulated cylinder have no ends of
/// their own and need limits. `unit` is the length of the part program's unit, mm. Errors: E0377
/// limits missing or impossible, E0378 no surface to spray.
[[nodiscard]] Result<Patch> patchOf(const Entity& entity, const Limits& limits, double unit);

}  // namespace arelem::spray
