#pragma once
#include "runtime/geometry/triangle_mesh.h"
#include "runtime/spray/surface/patch.h"

namespace arelem::spray {

/// A patch in triangles, two for each cell of a grid over its whole range.
struct PatchMesh {
  geometry::TriangleMesh mesh;
  /// How far triangles and surface lie apart at most, mm: proven where the patch knows its bounds,
  /// else twice what shows in the middles of the cells.
  double blur = 0.0;
};
[[nodiscard]] PatchMesh meshOf(const Patch& patch, std::uint32_t steps);

}  // namespace arelem::spray
