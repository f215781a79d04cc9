#pragma once
#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// An edge as it runs in one of its triangles.
struct MeshEdge {
  std::uint32_t low = 0, high = 0;  ///< vertices
  bool forward = false;             ///< from low to high
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;  ///< where it begins

  [[nodiscard]] bool joins(const MeshEdge& other) const {
    return low == other.low && high == other.high;
  }
};

/// All edges, those between the same two vertices side by side.
[[nodiscard]] std::vector<MeshEdge> edgesOf(const TriangleMesh& mesh);

/// Calls `use` with the edges of each two vertices.
template <class Use>
void forEachEdge(std::span<const MeshEdge> edges, Use use) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].joins(edges[i])) {
      ++end;
    }
    use(edges.subspan(i, end - i));
    i = end;
  }
}

}  // namespace arelem::geometry
