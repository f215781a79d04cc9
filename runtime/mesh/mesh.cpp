#include "runtime/mesh/mesh.h"

#include <cmath>

namespace arelem::mesh {

namespace {
bool isCount(double value, double most) {
  return value >= 0.0 && value <= most && value == std::floor(value);
}
}  // namespace

std::vector<double> Mesh::canon() const {
  std::vector<double> values = {static_cast<double>(corners.size()),
                                static_cast<double>(triangles.size())};
  values.reserve(2 + 3 * (corners.size() + triangles.size()));
  for (const Vec3& corner : corners) {
    values.insert(values.end(), corner.begin(), corner.end());
  }
  for (const auto& triangle : triangles) {
    values.insert(values.end(), triangle.begin(), triangle.end());
  }
  return values;
}

bool Mesh::readable(std::span<const double> canon) {
  const auto room = static_cast<double>(canon.size());
  if (canon.size() < 2 || !isCount(canon[0], room) || !isCount(canon[1], room) || canon[1] < 1.0 ||
      2.0 + 3.0 * (canon[0] + canon[1]) != room) {
    return false;
  }
  for (std::size_t i = 2 + 3 * static_cast<std::size_t>(canon[0]); i < canon.size(); ++i) {
    if (!isCount(canon[i], canon[0] - 1.0)) {
      return false;
    }
  }
  return true;
}

Mesh Mesh::of(std::span<const double> canon) {
  Mesh mesh;
  const auto corners = static_cast<std::size_t>(canon[0]);
  const auto triangles = static_cast<std::size_t>(canon[1]);
  std::size_t at = 2;
  mesh.corners.reserve(corners);
  for (std::size_t i = 0; i < corners; ++i, at += 3) {
    mesh.corners.emplace_back(canon[at], canon[at + 1], canon[at + 2]);
  }
  mesh.triangles.reserve(triangles);
  for (std::size_t i = 0; i < triangles; ++i, at += 3) {
    mesh.triangles.push_back({static_cast<std::size_t>(canon[at]),
                              static_cast<std::size_t>(canon[at + 1]),
                              static_cast<std::size_t>(canon[at + 2])});
  }
  return mesh;
}

Vec3 Mesh::spanned(std::size_t triangle) const {
  const auto& [a, b, c] = triangles[triangle];
  return (corners[b] - corners[a]).cross(corners[c] - corners[a]);
}

}  // namespace arelem::mesh
