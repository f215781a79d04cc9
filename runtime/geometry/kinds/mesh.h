#pragma once
#include <functional>
#include <memory>
#include <mutex>

#include "runtime/geometry/surface.h"
#include "runtime/geometry/triangle_tree.h"

namespace arelem::surface {

/// What its users have found out about a mesh and keep with it.
struct KeptWithMesh {
  KeptWithMesh() = default;
  KeptWithMesh(const KeptWithMesh&) = delete;
  KeptWithMesh& operator=(const KeptWithMesh&) = delete;
  virtual ~KeptWithMesh() = default;
};

/// A mesh with what queries need; shared between the copies of a surface.
struct MeshShape {
  explicit MeshShape(geometry::TriangleMesh mesh);

  geometry::TriangleMesh mesh;
  geometry::TriangleTree tree;
  std::vector<Vec3> normals;                     ///< unit, of each triangle
  std::vector<std::array<Vec3, 3>> edgeNormals;  ///< sum of the normals on both sides
  std::vector<Vec3> vertexNormals;               ///< sum of the normals around, by their angles
  std::vector<bool> atBorder;                    ///< vertices that triangles do not surround

  [[nodiscard]] Vec3 normalAt(std::size_t triangle, geometry::Feature feature) const;
  /// The one of those kept that `fits`, else what `make` makes; only the last few are kept.
  [[nodiscard]] std::shared_ptr<const KeptWithMesh> kept(
      const std::function<bool(const KeptWithMesh&)>& fits,
      const std::function<std::shared_ptr<const KeptWithMesh>()>& make) const;

 private:
  mutable std::mutex keeping_;
  mutable std::vector<std::shared_ptr<const KeptWithMesh>> kept_;  ///< the last one used last
};

/// MESH: positive on the side of its normals. The sign at edges and vertices is that of the normals
/// around them weighted by their angles (Baerentzen and Aanaes 2005), which is right wherever the
/// mesh is closed; beyond an open edge the surface goes on in no way, and the side is that of the
/// triangle at the edge.
class Mesh {
 public:
  struct Hint {
    int triangle = -1;  ///< of the last foot, -1: none
    geometry::Feature feature = geometry::Feature::face;
  };

  explicit Mesh(std::shared_ptr<const MeshShape> shape) : shape_(std::move(shape)) {}

  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] Bends bends(const Vec3&, const Foot& foot, double radius) const {
    return bendsOfAnySet(foot.distance, radius);
  }
  [[nodiscard]] const MeshShape& shape() const { return *shape_; }

 private:
  std::shared_ptr<const MeshShape> shape_;
};

}  // namespace arelem::surface
