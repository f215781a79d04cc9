#pragma once
#include <array>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// Finds triangles of a mesh by place: a tree of boxes over triangles in the order of places, which
/// takes a few sweeps to build and keeps neighbors together in memory.
///
/// A search is a class with `bool enters(const Vec3& center, const Vec3& half)`, whether triangles
/// inside this box could matter (`half`: half the box's lengths), and `void visit(std::size_t)`.
class TriangleTree {
 public:
  /// The mesh must have triangles.
  explicit TriangleTree(const TriangleMesh& mesh);

  /// All triangles, neighbors in space mostly side by side.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// The triangle nearest to p, of the same mesh. `guess` is one that is likely to be near, or -1.
  [[nodiscard]] std::size_t nearest(const TriangleMesh& mesh, const Vec3& p, int guess) const;
  /// A triangle down the tree by the lesser of `measure(center, half)`: likely the one of the
  /// least.
  template <class Measure>
  [[nodiscard]] std::size_t likely(Measure measure) const;
  /// Visits every triangle whose boxes are all entered; always in the same order.
  template <class Search>
  void search(Search& search) const;
  /// The same with something that is known of each box, begins as `known` and is handed down to
  /// what is inside: `bool enters(Known&, center, half, cover)` and `void visit(const Known&,
  /// size_t)`.
  template <class Search, class Known>
  void search(Search& search, const Known& known) const;

  /// A plane that the triangles of a small box are nearly in: none is beyond it. Boxes of slanted
  /// ones reach far beyond them.
  struct Cover {
    std::array<float, 3> normal{};  ///< its length is about 1, or 0 where there is no plane
    double most = 0.0;              ///< of normal.place
  };

 private:
  struct Box {
    std::array<double, 3> low, high;
    std::uint32_t first = 0;  ///< child, the other one follows; in leaves a place in the order
    std::uint32_t count = 0;  ///< triangles of a leaf, else 0
    Cover cover;

    [[nodiscard]] double squaredDistance(const Vec3& p) const;
  };
  /// Trees are no deeper: keys have 63 bits, and equal ones are halved.
  static constexpr std::size_t deepest = 63 + 33;

  class Builder;

  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;
};

template <class Search>
void TriangleTree::search(Search& search) const {
  struct Nothing {};
  struct Plain {
    Search& search;
    bool enters(Nothing& /*known*/, const Vec3& center, const Vec3& half, const Cover& /*cover*/) {
      return search.enters(center, half);
    }
    void visit(const Nothing& /*known*/, std::size_t i) { search.visit(i); }
  } plain{search};
  this->search(plain, Nothing{});
}

template <class Search, class Known>
void TriangleTree::search(Search& search, const Known& known) const {
  struct Later {
    std::uint32_t box;
    Known known;
  };
  std::array<Later, deepest> later;
  std::size_t waiting = 1;
  later[0] = {0, known};
  while (waiting > 0) {
    Later here = later[--waiting];
    const Box& box = boxes_[here.box];
    const Vec3 low(box.low[0], box.low[1], box.low[2]);
    const Vec3 high(box.high[0], box.high[1], box.high[2]);
    if (!search.enters(here.known, 0.5 * (low + high), 0.5 * (high - low), box.cover)) {
      continue;
    }
    if (box.count == 0) {
      later[waiting++] = {box.first + 1, here.known};
      later[waiting++] = {box.first, here.known};
    }
    for (std::uint32_t i = 0; i < box.count; ++i) {
      search.visit(here.known, order_[box.first + i]);
    }
  }
}

template <class Measure>
std::size_t TriangleTree::likely(Measure measure) const {
  const auto of = [&](const Box& box) {
    const Vec3 low(box.low[0], box.low[1], box.low[2]);
    const Vec3 high(box.high[0], box.high[1], box.high[2]);
    return measure(0.5 * (low + high), 0.5 * (high - low));
  };
  const Box* box = boxes_.data();
  while (box->count == 0) {
    const Box* first = &boxes_[box->first];
    box = of(first[1]) < of(first[0]) ? first + 1 : first;
  }
  return order_[box->first];
}

/// Where the point of a triangle nearest to p lies on it.
enum class Feature : std::uint8_t { face, edge0, edge1, edge2, vertex0, vertex1, vertex2 };
struct OnTriangle {
  Vec3 point = Vec3::Zero();
  Feature feature = Feature::face;  ///< edge k runs from corner k to corner k + 1
};
[[nodiscard]] OnTriangle nearestOn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

}  // namespace arelem::geometry
