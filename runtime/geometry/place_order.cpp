#include "runtime/geometry/place_order.h"

#include <algorithm>
#include <numeric>

namespace arelem::geometry {

namespace {
constexpr unsigned bitsOfAxis = 21;
constexpr unsigned digitBits = 11;
constexpr std::size_t digits = std::size_t{1} << digitBits;

/// The lowest 21 bits with two zeros between each.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32U) & 0x1f00000000ffffU;
  x = (x | x << 16U) & 0x1f0000ff0000ffU;
  x = (x | x << 8U) & 0x100f00f00f00f00fU;
  x = (x | x << 4U) & 0x10c30c30c30c30c3U;
  return (x | x << 2U) & 0x1249249249249249U;
}

std::vector<std::uint64_t> keysOf(const TriangleMesh& mesh) {
  Vec3 low = mesh.vertices[0];
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double size = (high - low).maxCoeff();
  const auto cells = static_cast<double>((std::uint64_t{1} << bitsOfAxis) - 1);
  const double scale = cells / (3.0 * size);
  std::vector<std::uint64_t> keys;
  keys.reserve(mesh.triangles.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3 place = mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]] - 3.0 * low;
    std::uint64_t key = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double cell = std::clamp(scale * place[axis], 0.0, cells);
      key |= spread(static_cast<std::uint64_t>(cell)) << axis;
    }
    keys.push_back(key);
  }
  return keys;
}
}  // namespace

/// Sorts by counting, digit by digit from the lowest one on.
PlaceOrder PlaceOrder::of(const TriangleMesh& mesh) {
  PlaceOrder order{std::vector<std::uint32_t>(mesh.triangles.size()), keysOf(mesh)};
  std::iota(order.triangles.begin(), order.triangles.end(), 0U);
  PlaceOrder sorted = order;
  for (unsigned shift = 0; shift < 3 * bitsOfAxis; shift += digitBits) {
    std::array<std::uint32_t, digits + 1> begin{};
    const auto digit = [&](std::size_t i) { return order.keys[i] >> shift & (digits - 1); };
    for (std::size_t i = 0; i < order.keys.size(); ++i) {
      ++begin[digit(i) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    for (std::size_t i = 0; i < order.keys.size(); ++i) {
      const std::uint32_t place = begin[digit(i)]++;
      sorted.keys[place] = order.keys[i];
      sorted.triangles[place] = order.triangles[i];
    }
    std::swap(order, sorted);
  }
  return order;
}

}  // namespace arelem::geometry
