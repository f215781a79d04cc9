#include "runtime/geometry/normal_cones.h"

#include <algorithm>
#include <limits>

namespace arelem::geometry {

namespace {
/// A normal whose direction is known worse than this, by the rounding of products of coordinates,
/// tells nothing.
constexpr double exactEnough = 1e-7;
constexpr double ulps = 16.0 * std::numeric_limits<double>::epsilon();

bool isExact(const TriangleMesh& mesh, std::size_t i) {
  const Vec3 u = mesh.corner(i, 1) - mesh.corner(i, 0);
  const Vec3 v = mesh.corner(i, 2) - mesh.corner(i, 0);
  const double size = mesh.corner(i, 0).cwiseAbs().maxCoeff() + u.norm() + v.norm();
  return ulps * size * (u.norm() + v.norm()) <= exactEnough * u.cross(v).norm();
}
}  // namespace

std::vector<NormalCone> normalCones(const TriangleMesh& mesh,
                                    std::span<const Vec3> normals,
                                    const std::vector<bool>& atBorder) {
  std::vector<NormalCone> cones(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      cones[v].axis += normals[i];
    }
  }
  for (std::size_t v = 0; v < cones.size(); ++v) {
    const double norm = cones[v].axis.norm();
    if (norm > 0.0 && !atBorder[v]) {
      cones[v].axis /= norm;
      cones[v].radius = exactEnough;
    }
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const bool exact = isExact(mesh, i);
    for (const std::uint32_t v : mesh.triangles[i]) {
      const double from = exact ? (normals[i] - cones[v].axis).norm() : NormalCone::any;
      cones[v].radius = std::max(cones[v].radius, from + exactEnough);
    }
  }
  return cones;
}

}  // namespace arelem::geometry
