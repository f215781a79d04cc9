#include "runtime/geometry/mesh_edges.h"

#include <algorithm>
#include <tuple>

namespace arelem::geometry {

/// Sorted by the lower vertex by counting, the few of one vertex by comparing.
std::vector<MeshEdge> edgesOf(const TriangleMesh& mesh) {
  std::vector<std::size_t> begin(mesh.vertices.size() + 1, 0);
  const auto forEach = [&](auto use) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = mesh.triangles[i][k];
        const std::uint32_t b = mesh.triangles[i][(k + 1) % 3];
        use(MeshEdge{std::min(a, b), std::max(a, b), a < b, static_cast<std::uint32_t>(i), k});
      }
    }
  };
  forEach([&](const MeshEdge& e) { ++begin[e.low + 1]; });
  for (std::size_t v = 1; v < begin.size(); ++v) {
    begin[v] += begin[v - 1];
  }
  std::vector<MeshEdge> edges(3 * mesh.triangles.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  forEach([&](const MeshEdge& e) { edges[next[e.low]++] = e; });
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              edges.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const MeshEdge& a, const MeshEdge& b) {
                return std::tie(a.high, a.forward, a.triangle) <
                       std::tie(b.high, b.forward, b.triangle);
              });
  }
  return edges;
}

}  // namespace arelem::geometry
