#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/geometry/shapes.h"

namespace arelem::geometry {

/// MESH: triangles whose normals, by the right hand rule, point to the positive side.
///
/// Canonical form: number of vertices, number of triangles, x y z of each vertex, three vertex
/// numbers (from 1) of each triangle.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;  ///< vertices, from 0
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;

  /// The values must have passed `checkedMesh`.
  [[nodiscard]] static TriangleMesh of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  [[nodiscard]] const Vec3& corner(std::size_t triangle, std::size_t k) const {
    return vertices[triangles[triangle][k]];
  }
};

/// Joins vertices at the same place and leaves out triangles without area. Errors: E0344 no
/// triangles or not finite, E0345 an edge of more than two triangles, E0346 neighbors that are
/// turned against each other.
[[nodiscard]] Result<TriangleMesh> checkedMesh(TriangleMesh mesh, std::string_view name);

/// Edges that belong to one triangle only; 0 for a closed mesh.
[[nodiscard]] std::size_t openEdges(const TriangleMesh& mesh);

/// The mesh of a canonical form. Errors: those of `checkedMesh`, E0308 for wrong counts and
/// numbers.
[[nodiscard]] Result<TriangleMesh> meshOfCanon(std::span<const double> canon);

}  // namespace arelem::geometry
