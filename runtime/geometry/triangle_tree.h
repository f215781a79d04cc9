#pragma once
#include <memory>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// Goes through a tree of boxes and skips those that cannot matter.
class TriangleSearch {
 public:
  virtual ~TriangleSearch() = default;
  /// Whether triangles inside this box could matter. `half`: half the box's lengths.
  [[nodiscard]] virtual bool enters(const Vec3& center, const Vec3& half) = 0;
  virtual void visit(std::size_t triangle) = 0;
};

/// Finds triangles of a mesh by place.
class TriangleTree {
 public:
  virtual ~TriangleTree() = default;
  /// The triangle nearest to p. `guess` is one that is likely to be near, or -1.
  [[nodiscard]] virtual std::size_t nearest(const Vec3& p, int guess) const = 0;
  /// Visits every triangle whose boxes are all entered; always in the same order.
  virtual void search(TriangleSearch& search) const = 0;
};

/// The mesh must have triangles; it is copied.
[[nodiscard]] std::unique_ptr<TriangleTree> makeTree(const TriangleMesh& mesh);

/// Where the point of a triangle nearest to p lies on it.
enum class Feature : std::uint8_t { face, edge0, edge1, edge2, vertex0, vertex1, vertex2 };
struct OnTriangle {
  Vec3 point = Vec3::Zero();
  Feature feature = Feature::face;  ///< edge k runs from corner k to corner k + 1
};
[[nodiscard]] OnTriangle nearestOn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

}  // namespace arelem::geometry
