#pragma once
#include <span>
#include <vector>

#include "ir/diag/result.h"
#include "ir/space/vector.h"
#include "runtime/spray/outline.h"

/// Planar regions: what is painted (REGION).
namespace arelem::region {

using Corners = std::vector<Vec3>;

/// Outlines with holes and islands in one plane. Seen against the normal outlines run
/// counterclockwise and holes clockwise. Lengths in the unit of the part program.
///
/// Canonical form: normal i j k, number of loops, then for each loop the number of corners and
/// their coordinates.
struct Region {
  Vec3 normal = Vec3::UnitZ();
  std::vector<Corners> loops;

  [[nodiscard]] std::vector<double> canon() const;
  /// Whether the numbers have this layout.
  [[nodiscard]] static bool readable(std::span<const double> canon);
  [[nodiscard]] static Region of(std::span<const double> canon);
};

/// A boundary as it was defined.
struct Boundary {
  enum class Role : std::uint8_t {
    outline,
    hole,    ///< inside an outline or island
    island,  ///< inside a hole, or beside the outlines
    byPlace  ///< an outline or a hole by how deep it lies in others
  };
  Role role = Role::outline;
  Corners corners;
};

/// Checks boundaries and turns them the right way round. The normal points up (to positive z, else
/// y, else x). Errors: E0360 too few corners, E0361 not in one plane, E0362 crossing, E0363 hole or
/// island in the wrong place, E0364 no area.
[[nodiscard]] Result<Region> regionOf(std::vector<Boundary> boundaries);

/// The plane of a region: place = origin + x u + y v. `x` is the base x axis seen in the plane (the
/// y axis where that is its normal), the origin the place nearest to 0,0,0; a region of the xy
/// plane keeps its coordinates.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Vec3 x = Vec3::UnitX();
  Vec3 y = Vec3::UnitY();
  Vec3 normal = Vec3::UnitZ();
  [[nodiscard]] Vec3 inSpace(const spray::Vec2& place) const {
    return origin + place.x() * x + place.y() * y;
  }
  [[nodiscard]] spray::Vec2 inPlane(const Vec3& place) const {
    return {(place - origin).dot(x), (place - origin).dot(y)};
  }
};
[[nodiscard]] Frame frameOf(const Vec3& normal, const Vec3& somePlace);

/// A region in its plane; lengths times `scale`.
struct Flat {
  Frame frame;
  spray::Outline outline;
};
[[nodiscard]] Flat flattened(const Region& region, double scale);

}  // namespace arelem::region
