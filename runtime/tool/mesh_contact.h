#pragma once
#include <optional>
#include <utility>

#include "runtime/geometry/triangle_mesh.h"
#include "runtime/tool/profile.h"

namespace arelem::tool {

/// The least signed distance of any point of a triangle to the body of a cutter: negative by how
/// deep the triangle is inside. With a fixed axis and a convex cutter it is a convex function of
/// the tool end, as it is the least of a function that is convex in both.
struct TriangleGap {
  double gap = 0.0;
  Vec3 normal = Vec3::UnitZ();   ///< unit, from the triangle to the cutter; the gradient of the gap
  Vec3 onCutter = Vec3::Zero();  ///< the contact
};

/// A cutter in one position, against triangles.
class TriangleCutter {
 public:
  TriangleCutter(const Profile& cutter, const Vec3& te, const Vec3& axis);

  [[nodiscard]] TriangleGap gapTo(const geometry::TriangleMesh& mesh, std::size_t triangle) const;
  /// Never more than the gap.
  [[nodiscard]] double lowerBound(const geometry::TriangleMesh& mesh, std::size_t triangle) const;
  /// Corners of a box that holds all places nearer to the cutter than `beyond`.
  [[nodiscard]] std::pair<Vec3, Vec3> box(double beyond) const;

 private:
  [[nodiscard]] double distance(const Vec3& place) const;
  [[nodiscard]] std::optional<TriangleGap> ballGap(const Vec3& a,
                                                   const Vec3& b,
                                                   const Vec3& c) const;
  [[nodiscard]] TriangleGap contactAt(const Vec3& place) const;
  void considerEdge(const Vec3& a, const Vec3& b, TriangleGap& best) const;

  const Profile& cutter_;
  Vec3 te_, axis_;
};

}  // namespace arelem::tool
