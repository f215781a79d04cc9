#pragma once
#include <array>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::spray {

/// A cube from the origin, its faces outwards.
inline geometry::TriangleMesh box(double size) {
  geometry::TriangleMesh m;
  for (int i = 0; i < 8; ++i) {
    m.vertices.emplace_back((i & 1) * size, ((i >> 1) & 1) * size, ((i >> 2) & 1) * size);
  }
  for (const auto& q : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                        {4, 5, 7, 6},
                        {0, 1, 5, 4},
                        {2, 6, 7, 3},
                        {0, 4, 6, 2},
                        {1, 3, 7, 5}}) {
    m.triangles.push_back({q[0], q[1], q[2]});
    m.triangles.push_back({q[0], q[2], q[3]});
  }
  return m;
}

}  // namespace arelem::spray
