#pragma once
#include <array>

#include "runtime/geometry/triangle_mesh.h"
#include "runtime/spray/surface/surface_lines.h"

/// What the planes of LIMITS keep of a surface.
namespace arelem::spray {

/// The pieces of a line on a patch that lie on the kept side of all planes. Ends are found between
/// the parameters of neighboring points, so that they lie on the surface: the line runs along u or
/// v, or its points are close.
[[nodiscard]] std::vector<SurfaceLine> keptPieces(const Patch& patch, const SurfaceLine& line);

/// Places that span what is kept, over a grid of `count` by `count` cells, and the pairs of them
/// that are neighbors: nodes of the grid, and places on its lines where a plane cuts them.
struct KeptGrid {
  std::vector<Vec3> places;
  std::vector<std::pair<std::size_t, std::size_t>> neighbors;
};
[[nodiscard]] KeptGrid keptGrid(const Patch& patch, int count);

/// Makes the range of the parameters as small as what is kept allows, a cell of a grid of 128 more;
/// `turns` tells which of them go round. False where nothing is kept.
[[nodiscard]] bool shrinkToKept(Patch& patch, bool uTurns, bool vTurns);

/// A mesh with the normals at the corners of each triangle.
struct ShadedMesh {
  geometry::TriangleMesh mesh;
  std::vector<std::array<Vec3, 3>> normals;
};
/// What lies on the kept side of all planes. Neighbors stay neighbors, and normals what they were:
/// a cut must not bend the surface.
[[nodiscard]] ShadedMesh clipped(ShadedMesh whole, const std::vector<HalfSpace>& keep);

}  // namespace arelem::spray
