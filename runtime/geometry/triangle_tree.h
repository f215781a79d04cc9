#pragma once
#include <memory>
#include <vector>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// Finds triangles of a mesh by place.
class TriangleTree {
 public:
  virtual ~TriangleTree() = default;
  /// The triangle nearest to p. `guess` is one that is likely to be near, or -1.
  [[nodiscard]] virtual std::size_t nearest(const Vec3& p, int guess) const = 0;
  /// The triangles that meet the box from `low` to `high`, appended in no order that matters.
  virtual void within(const Vec3& low, const Vec3& high, std::vector<std::size_t>& found) const = 0;
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
