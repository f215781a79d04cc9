#include "runtime/geometry/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ir/diag/geometry.h"

namespace arelem::geometry {

TriangleMesh TriangleMesh::of(std::span<const double> canon) {
  TriangleMesh mesh;
  const auto vertexCount = static_cast<std::size_t>(canon[0]);
  const auto triangleCount = static_cast<std::size_t>(canon[1]);
  mesh.vertices.reserve(vertexCount);
  mesh.triangles.reserve(triangleCount);
  std::size_t next = 2;
  for (std::size_t i = 0; i < vertexCount; ++i, next += 3) {
    mesh.vertices.emplace_back(canon[next], canon[next + 1], canon[next + 2]);
  }
  for (std::size_t i = 0; i < triangleCount; ++i, next += 3) {
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      t[k] = static_cast<std::uint32_t>(canon[next + k]) - 1;
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

Canon TriangleMesh::canon() const {
  Canon canon;
  canon.reserve(2 + 3 * (vertices.size() + triangles.size()));
  canon.push_back(static_cast<double>(vertices.size()));
  canon.push_back(static_cast<double>(triangles.size()));
  for (const Vec3& v : vertices) {
    canon.insert(canon.end(), v.begin(), v.end());
  }
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) {
      canon.push_back(v + 1.0);
    }
  }
  return canon;
}

namespace {
/// An edge as it runs in one of its triangles.
struct Edge {
  std::uint32_t low, high;
  bool forward;  ///< from low to high

  friend bool operator<(const Edge& a, const Edge& b) {
    return a.low != b.low     ? a.low < b.low
           : a.high != b.high ? a.high < b.high
                              : a.forward < b.forward;
  }
  [[nodiscard]] bool joins(const Edge& other) const {
    return low == other.low && high == other.high;
  }
};

std::vector<Edge> sortedEdges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Calls `use` with the first edge and the number of each group of the same two vertices.
template <class Use>
void forEachEdge(const std::vector<Edge>& edges, Use use) {
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].joins(edges[i])) {
      ++end;
    }
    use(edges[i], end - i, i);
    i = end;
  }
}

bool lessByPlace(const Vec3& a, const Vec3& b) {
  return a.x() != b.x() ? a.x() < b.x() : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
}

/// One vertex for each place, in the order of their first use.
void join(TriangleMesh& mesh) {
  std::vector<std::uint32_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3& p = mesh.vertices[a];
    const Vec3& q = mesh.vertices[b];
    return p == q ? a < b : lessByPlace(p, q);
  });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && mesh.vertices[order[i]] == mesh.vertices[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(order.size(), unused);
  std::vector<Vec3> kept;
  std::vector<TriangleMesh::Triangle> triangles;
  for (TriangleMesh::Triangle t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]];
    const Vec3 across = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
    if (!(across.squaredNorm() > 0.0)) {
      continue;
    }
    for (std::uint32_t& v : t) {
      std::uint32_t& n = number[first[v]];
      if (n == unused) {
        n = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.vertices[v] + Vec3::Zero());  // no minus zeros
      }
      v = n;
    }
    triangles.push_back(t);
  }
  mesh.vertices = std::move(kept);
  mesh.triangles = std::move(triangles);
}

std::string placeText(const Vec3& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
}
}  // namespace

Result<TriangleMesh> checkedMesh(TriangleMesh mesh, std::string_view name) {
  for (const Vec3& v : mesh.vertices) {
    if (!v.allFinite()) {
      return fail(diag::MeshBroken, name, std::string("a coordinate is not a finite number"));
    }
  }
  join(mesh);
  if (mesh.triangles.empty()) {
    return fail(diag::MeshBroken, name, std::string("it has no triangle with an area"));
  }
  std::optional<Failure> bad;
  const std::vector<Edge> edges = sortedEdges(mesh);
  forEachEdge(edges, [&](const Edge& edge, std::size_t count, std::size_t at) {
    const std::string from = placeText(mesh.vertices[edge.low]);
    if (bad) {
      return;
    }
    if (count > 2) {
      bad = fail(diag::MeshNotManifold, name, from, placeText(mesh.vertices[edge.high]),
                 std::uint64_t{count});
    } else if (count == 2 && edges[at].forward == edges[at + 1].forward) {
      bad = fail(diag::MeshTurned, name, from, placeText(mesh.vertices[edge.high]));
    }
  });
  if (bad) {
    return *std::move(bad);
  }
  return mesh;
}

std::size_t openEdges(const TriangleMesh& mesh) {
  std::size_t open = 0;
  forEachEdge(sortedEdges(mesh),
              [&](const Edge&, std::size_t count, std::size_t) { open += count == 1 ? 1 : 0; });
  return open;
}

Result<TriangleMesh> meshOfCanon(std::span<const double> canon) {
  const auto wrong = [&](std::size_t i, std::string_view rule) {
    return fail(diag::BadCanonicalValue, "MESH", i + 1, canon[i], rule);
  };
  constexpr double most = 1e9;
  const auto isCount = [](double v, double least) {
    return v >= least && v <= most && v == std::floor(v);
  };
  if (canon.size() < 2) {
    return fail(diag::WrongCanonicalCount, "MESH", canon.size(), "the two counts first");
  }
  if (!isCount(canon[0], 3.0)) {
    return wrong(0, "the number of vertices, from 3");
  }
  if (!isCount(canon[1], 1.0)) {
    return wrong(1, "the number of triangles, from 1");
  }
  const auto wanted = static_cast<std::size_t>(2.0 + 3.0 * (canon[0] + canon[1]));
  if (canon.size() != wanted) {
    return fail(diag::WrongCanonicalCount, "MESH", canon.size(), fmt::format("{}", wanted));
  }
  for (std::size_t i = 2 + 3 * static_cast<std::size_t>(canon[0]); i < canon.size(); ++i) {
    if (!isCount(canon[i], 1.0) || canon[i] > canon[0]) {
      return wrong(i, "the number of a vertex");
    }
  }
  return checkedMesh(TriangleMesh::of(canon), "MESH/CANON");
}

}  // namespace arelem::geometry
