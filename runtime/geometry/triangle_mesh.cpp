#include "runtime/geometry/triangle_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "ir/diag/geometry.h"
#include "runtime/geometry/mesh_edges.h"

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
/// Of each vertex the first one at the same place, by a table of places.
std::vector<std::uint32_t> firstAtPlace(const std::vector<Vec3>& vertices) {
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::size_t size = 16;
  while (size < 2 * vertices.size()) {
    size *= 2;
  }
  std::vector<std::uint32_t> table(size, unused);
  std::vector<std::uint32_t> first(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::uint64_t hash = 0;
    for (const double x : vertices[i]) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;  // no minus zero
      hash ^= hash >> 32U;
    }
    std::size_t slot = hash & (size - 1);
    while (table[slot] != unused && vertices[table[slot]] != vertices[i]) {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] == unused) {
      table[slot] = static_cast<std::uint32_t>(i);
    }
    first[i] = table[slot];
  }
  return first;
}

/// One vertex for each place, in the order of their first use.
void join(TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = firstAtPlace(mesh.vertices);
  constexpr auto unused = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(first.size(), unused);
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

/// Of the triangles at an edge that is wrong: one that is in the file twice, if that is why.
Failure withTwin(Failure failure, const TriangleMesh& mesh, std::span<const MeshEdge> edge) {
  const auto sorted = [&](const MeshEdge& e) {
    TriangleMesh::Triangle t = mesh.triangles[e.triangle];
    std::sort(t.begin(), t.end());
    return t;
  };
  for (std::size_t i = 0; i < edge.size(); ++i) {
    for (std::size_t k = i + 1; k < edge.size(); ++k) {
      if (sorted(edge[i]) == sorted(edge[k])) {
        const auto& [a, b, c] = mesh.triangles[edge[i].triangle];
        return std::move(failure).withHelp(
            fmt::format("the triangle {}, {}, {} is in it twice", placeText(mesh.vertices[a]),
                        placeText(mesh.vertices[b]), placeText(mesh.vertices[c])));
      }
    }
  }
  return failure;
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
  forEachEdge(edgesOf(mesh), [&](std::span<const MeshEdge> edge) {
    const auto place = [&](std::uint32_t vertex) { return placeText(mesh.vertices[vertex]); };
    if (bad) {
      return;
    }
    if (edge.size() > 2) {
      bad = withTwin(fail(diag::MeshNotManifold, name, place(edge[0].low), place(edge[0].high),
                          std::uint64_t{edge.size()}),
                     mesh, edge);
    } else if (edge.size() == 2 && edge[0].forward == edge[1].forward) {
      bad = withTwin(fail(diag::MeshTurned, name, place(edge[0].low), place(edge[0].high)), mesh,
                     edge);
    }
  });
  if (bad) {
    return *std::move(bad);
  }
  return mesh;
}

std::size_t openEdges(const TriangleMesh& mesh) {
  std::size_t open = 0;
  forEachEdge(edgesOf(mesh),
              [&](std::span<const MeshEdge> edge) { open += edge.size() == 1 ? 1 : 0; });
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
