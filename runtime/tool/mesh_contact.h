#pragma once
#include <optional>

#include "runtime/geometry/triangle_tree.h"
#include "runtime/tool/profile.h"

namespace arelem::tool {

/// The least signed distance of any point of a triangle to the body of a cutter: negative by how
/// deep the triangle is inside. With a fixed axis and a convex cutter it is a convex function of
/// the tool end, as it is the least of a function that is convex in both.
struct TriangleGap {
  double gap = 0.0;
  Vec3 normal = Vec3::UnitZ();   ///< unit, from the triangle to the cutter; the gradient of the gap
  Vec3 onCutter = Vec3::Zero();  ///< the contact
  /// The gap of other tool ends lies above the tangent of this one. Not so where the triangle is
  /// inside an edge of the cutter.
  bool tangent = true;
};

/// A cutter in one position, or on a straight way through it, against triangles.
class TriangleCutter {
 public:
  /// `sweep`: the bounds hold for all tool ends from te - sweep to te + sweep.
  TriangleCutter(const Profile& cutter,
                 const Vec3& te,
                 const Vec3& axis,
                 const Vec3& sweep = Vec3::Zero());

  [[nodiscard]] TriangleGap gapTo(const geometry::TriangleMesh& mesh, std::size_t triangle) const;
  /// False where no place of the triangle, and none of the box, comes nearer than `gap` (anywhere
  /// on the way); true where it may. `half`: half the box's lengths.
  [[nodiscard]] bool mayReach(const geometry::TriangleMesh& mesh,
                              std::size_t triangle,
                              double gap) const;
  [[nodiscard]] bool mayReach(const Vec3& center, const Vec3& half, double gap) const;

 private:
  /// The signed distance of a place to the body, and its gradient.
  struct Away {
    double distance = 0.0;
    Vec3 gradient = Vec3::Zero();
    Vec3 onCutter = Vec3::Zero();
  };
  [[nodiscard]] Away away(const Vec3& place) const;
  [[nodiscard]] bool isBeside(const Vec3& low, const Vec3& high, double gap) const;
  template <class Spread>
  [[nodiscard]] bool mayReachAround(const Vec3& center, double gap, Spread spread) const;
  [[nodiscard]] double distance(const Vec3& place) const;
  [[nodiscard]] std::optional<TriangleGap> ballGap(const Vec3& a,
                                                   const Vec3& b,
                                                   const Vec3& c) const;
  [[nodiscard]] TriangleGap contactAt(const Vec3& place) const;
  void considerEdge(const Vec3& a, const Vec3& b, TriangleGap& best) const;
  [[nodiscard]] TriangleGap ofPlane(const Vec3& on, const Vec3& normal) const;
  [[nodiscard]] Vec3 deepestPlace(const Vec3& on, const Vec3& normal) const;

  const Profile& cutter_;
  Vec3 te_, axis_, sweep_;
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
