#pragma once
#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// Triangles in the order of a curve through all cells of their box (Morton 1966), so that
/// neighbors in space are mostly neighbors in the order.
struct PlaceOrder {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint64_t> keys;  ///< of each in this order; 63 bits, ascending

  static PlaceOrder of(const TriangleMesh& mesh);
};

}  // namespace arelem::geometry
