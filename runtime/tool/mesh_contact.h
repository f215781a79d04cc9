#pragma once
#include "runtime/geometry/triangle_tree.h"
#include "runtime/tool/triangle_gap.h"

namespace arelem::tool {

/// A cutter in one position, or on a straight way through it, against triangles.
class TriangleCutter {
 public:
  /// `sweep`: the bounds hold for all tool ends from te - sweep to te + sweep.
  TriangleCutter(const Body& cutter,
                 const Vec3& te,
                 const Vec3& axis,
                 const Vec3& sweep = Vec3::Zero());

  [[nodiscard]] TriangleGap gapTo(const geometry::TriangleMesh& mesh, std::size_t triangle) const {
    return gapOf(body_, facet(mesh, triangle));
  }
  /// The same, but of a gap above `enough` only that it is.
  [[nodiscard]] TriangleGap gapTo(const geometry::TriangleMesh& mesh,
                                  std::size_t triangle,
                                  double enough) const {
    return gapOf(body_, facet(mesh, triangle), enough);
  }
  /// False where no place of the triangle, and none of the box, comes nearer than `gap` (anywhere
  /// on the way); true where it may. `half`: half the box's lengths.
  [[nodiscard]] bool mayReach(const geometry::TriangleMesh& mesh,
                              std::size_t triangle,
                              double gap) const;
  [[nodiscard]] bool mayReach(const Vec3& center, const Vec3& half, double gap) const;

 private:
  static Facet facet(const geometry::TriangleMesh& mesh, std::size_t triangle) {
    return Facet::of(mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2));
  }
  [[nodiscard]] bool isBeside(const Vec3& low, const Vec3& high, double gap) const;
  template <class Spread>
  [[nodiscard]] bool mayReachAround(const Vec3& center, double gap, Spread spread) const;

  PlacedBody body_;
  Vec3 sweep_;
  bool upright_;   ///< the axis is z
  bool straight_;  ///< the sides are parallel to the axis, the bottom is square to it
  /// The cutter lies within the upright cylinder of this radius from this height above the tool end
  /// upwards, thickened by the ball.
  double radius_, height_, ball_;
};

/// The least gap to a mesh. `triangle` is one that is likely to be near, and becomes the nearest.
[[nodiscard]] TriangleGap leastGap(const TriangleCutter& cutter,
                                   const geometry::TriangleMesh& mesh,
                                   const geometry::TriangleTree& tree,
                                   std::size_t& triangle);

}  // namespace arelem::tool
