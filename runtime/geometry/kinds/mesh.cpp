#include "runtime/geometry/kinds/mesh.h"

#include <algorithm>
#include <cmath>

#include "runtime/geometry/mesh_edges.h"
#include "runtime/geometry/mesh_foot.h"

namespace arelem::surface {

using geometry::Feature;

namespace {
/// A place this near to the mesh, as a share of its coordinates' size, is on it.
constexpr double onMesh = 1e-13;

constexpr std::size_t mostKept = 4;
}  // namespace

MeshShape::MeshShape(geometry::TriangleMesh given) : mesh(std::move(given)), tree(mesh) {
  const std::size_t count = mesh.triangles.size();
  normals.reserve(count);
  edgeNormals.resize(count);
  vertexNormals.assign(mesh.vertices.size(), Vec3::Zero());
  atBorder.assign(mesh.vertices.size(), false);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& t = mesh.triangles[i];
    const Vec3 normal = (mesh.corner(i, 1) - mesh.corner(i, 0))
                            .cross(mesh.corner(i, 2) - mesh.corner(i, 0))
                            .normalized();
    normals.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 u = mesh.corner(i, (k + 1) % 3) - mesh.corner(i, k);
      const Vec3 v = mesh.corner(i, (k + 2) % 3) - mesh.corner(i, k);
      vertexNormals[t[k]] += std::atan2(u.cross(v).norm(), u.dot(v)) * normal;
    }
  }
  geometry::forEachEdge(geometry::edgesOf(mesh), [&](std::span<const geometry::MeshEdge> edge) {
    if (edge.size() != 2) {
      atBorder[edge[0].low] = atBorder[edge[0].high] = true;
    }
    Vec3 sum = Vec3::Zero();
    for (const geometry::MeshEdge& e : edge) {
      sum += normals[e.triangle];
    }
    for (const geometry::MeshEdge& e : edge) {
      edgeNormals[e.triangle][e.corner] = sum;
    }
  });
}

std::shared_ptr<const KeptWithMesh> MeshShape::kept(
    const std::function<bool(const KeptWithMesh&)>& fits,
    const std::function<std::shared_ptr<const KeptWithMesh>()>& make) const {
  const std::scoped_lock lock(keeping_);
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const auto& one) { return fits(*one); });
  if (found != kept_.end()) {
    std::rotate(found, found + 1, kept_.end());
    return kept_.back();
  }
  if (kept_.size() == mostKept) {
    kept_.erase(kept_.begin());
  }
  kept_.push_back(make());
  return kept_.back();
}

Vec3 MeshShape::normalAt(std::size_t triangle, Feature feature) const {
  const auto place = static_cast<std::size_t>(feature);
  if (feature == Feature::face) {
    return normals[triangle];
  }
  return place <= 3 ? edgeNormals[triangle][place - 1]
                    : vertexNormals[mesh.triangles[triangle][place - 4]];
}

Foot footOn(const MeshShape& s, std::size_t i, const Vec3& p, Mesh::Hint& hint) {
  const geometry::OnTriangle on =
      geometry::nearestOn(s.mesh.corner(i, 0), s.mesh.corner(i, 1), s.mesh.corner(i, 2), p);
  hint = {static_cast<int>(i), on.feature};
  const Vec3 w = p - on.point;
  const double distance = w.norm();
  const Vec3 around = s.normalAt(i, on.feature);
  const double sign = w.dot(around) < 0.0 ? -1.0 : 1.0;
  if (distance <= onMesh * (1.0 + p.cwiseAbs().maxCoeff())) {
    const double length = around.norm();
    return {sign * distance, length > 0.0 ? Vec3(around / length) : s.normals[i]};
  }
  if (on.feature == Feature::face) {
    return {sign * distance, s.normals[i]};
  }
  return {sign * distance, sign / distance * w};
}

Foot Mesh::foot(const Vec3& p, Hint& hint) const {
  return footOn(*shape_, shape_->tree.nearest(shape_->mesh, p, hint.triangle), p, hint);
}

double Mesh::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  if (hint.triangle < 0 || hint.feature == Feature::face || foot.distance == 0.0) {
    return 0.0;
  }
  const double along = foot.normal.dot(t);
  double across = t.squaredNorm() - along * along;
  const auto place = static_cast<std::size_t>(hint.feature);
  if (place <= 3) {
    // Along an edge nothing bends.
    const auto i = static_cast<std::size_t>(hint.triangle);
    const Vec3 edge =
        (shape_->mesh.corner(i, place % 3) - shape_->mesh.corner(i, place - 1)).normalized();
    across -= edge.dot(t) * edge.dot(t);
  }
  return across / foot.distance;
}

}  // namespace arelem::surface
