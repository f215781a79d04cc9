#include "runtime/spray/surface/patch_mesh.h"

#include <algorithm>
#include <cmath>

namespace arelem::spray {

PatchMesh meshOf(const Patch& patch, std::uint32_t steps) {
  const auto at = [&](double i, double k) {
    return patch.at(patch.u0 + (patch.u1 - patch.u0) * i / steps,
                    patch.v0 + (patch.v1 - patch.v0) * k / steps);
  };
  PatchMesh result;
  geometry::TriangleMesh& mesh = result.mesh;
  double seen = 0.0;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    for (std::uint32_t k = 0; k <= steps; ++k) {
      mesh.vertices.push_back(at(i, k));
      if (i == steps || k == steps) {
        continue;
      }
      const std::uint32_t own = i * (steps + 1) + k;
      const std::uint32_t right = own + steps + 1;
      mesh.triangles.push_back({own, right, right + 1});
      mesh.triangles.push_back({own, right + 1, own + 1});
      const Vec3 middle = (at(i, k) + at(i + 1.0, k + 1.0)) / 2.0;
      seen = std::max(seen, (at(i + 0.5, k + 0.5) - middle).norm());
    }
  }
  std::erase_if(mesh.triangles, [&mesh](const auto& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm() == 0.0;
  });
  // What is straight between corners lies (h^2 f_uu + 2 h k f_uv + k^2 f_vv) / 8 off at most.
  const double h = (patch.u1 - patch.u0) / steps;
  const double k = (patch.v1 - patch.v0) / steps;
  result.blur = 2.0 * seen;
  if (patch.bend) {
    const Patch::Bend bend = patch.bend(std::max(std::abs(patch.v0), std::abs(patch.v1)));
    result.blur = (h * h * bend.uu + 2.0 * h * k * bend.uv + k * k * bend.vv) / 8.0;
  }
  return result;
}

}  // namespace arelem::spray
