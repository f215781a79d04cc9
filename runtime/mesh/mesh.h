#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"
#include "ir/space/vector.h"

/// Surfaces of triangles, as CAD systems and scanners write them.
namespace arelem::mesh {

/// Triangles run counterclockwise seen from the side that their normals point to.
struct Mesh {
  std::vector<Vec3> corners;
  std::vector<std::array<std::size_t, 3>> triangles;  ///< places in `corners`

  /// {number of corners, number of triangles, x y z ..., i j k ...}
  [[nodiscard]] std::vector<double> canon() const;
  /// Whether numbers are the canon of a mesh: counts that fit, indices that exist.
  [[nodiscard]] static bool readable(std::span<const double> canon);
  [[nodiscard]] static Mesh of(std::span<const double> canon);

  /// Twice the area of a triangle along its normal.
  [[nodiscard]] Vec3 spanned(std::size_t triangle) const;
};

enum class Format : std::uint8_t { stl, obj, ply, off };

/// Reads the bytes of a file: STL text and binary, OBJ, PLY text and binary of both byte orders,
/// OFF. Polygons become fans of triangles, corners at the very same place one corner, triangles
/// without area are left out. Errors: E0357 with the line (or 0 in binary data) and what is wrong,
/// E0358 nothing with an area. Time and memory: linear in the bytes.
[[nodiscard]] Result<Mesh> readMesh(std::string_view bytes, Format format, std::string_view name);

}  // namespace arelem::mesh
