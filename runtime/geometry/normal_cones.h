#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/geometry/triangle_mesh.h"

namespace arelem::geometry {

/// With which normals something convex that stays on one side of a mesh can touch its triangles.
///
/// What lies on one side of a plane through a vertex has the plane's normal among those that the
/// normals of the triangles around it span, where these surround the vertex and all look to one
/// side: else a direction would lie above all these triangles and below one of them. So a triangle,
/// with its edges and corners, is only touched with normals in a cone about those of its neighbors.
/// Triangles at a border are touched with any.
class NormalCones {
 public:
  struct Cone {
    std::array<float, 3> axis{};  ///< its length is about 1
    float radius = any;           ///< no normal is farther from the axis

    [[nodiscard]] bool isAny() const { return radius >= any; }
    [[nodiscard]] Vec3 direction() const { return {axis[0], axis[1], axis[2]}; }
  };
  /// Cones from this radius on are not used.
  static constexpr float any = 0.9F;

  /// `order`: the triangles so that those next to each other are neighbors. `atBorder`: vertices
  /// that triangles do not surround.
  NormalCones(const TriangleMesh& mesh,
              std::span<const Vec3> normals,
              const std::vector<bool>& atBorder,
              std::span<const std::uint32_t> order);

  /// Visits every triangle whose boxes are all entered; always in the same order. What is known of
  /// a box, at first `known`, is handed down to its parts: `bool enters(Known&, center, half,
  /// cone)` and `void visit(const Known&, triangle, cone)`.
  template <class Search, class Known>
  void search(Search& search, const Known& known) const;

 private:
  /// Each part of a level has this many of the level below.
  static constexpr std::size_t parts = 4;

  struct Box {
    std::array<float, 3> low, high;
    Cone cone;
  };

  void addTriangles(const TriangleMesh& mesh,
                    std::span<const Vec3> normals,
                    const std::vector<bool>& atBorder);
  void addLevel();
  template <class Search, class Known>
  void searchIn(std::size_t level, std::size_t place, Search& search, Known known) const;

  std::vector<std::uint32_t> order_;
  std::vector<Cone> cones_;               ///< of each in the order
  std::vector<std::vector<Box>> levels_;  ///< the first: of `parts` triangles each
};

template <class Search, class Known>
void NormalCones::search(Search& search, const Known& known) const {
  const std::size_t top = levels_.size() - 1;
  for (std::size_t i = 0; i < levels_[top].size(); ++i) {
    searchIn(top, i, search, known);
  }
}

template <class Search, class Known>
void NormalCones::searchIn(std::size_t level,
                           std::size_t place,
                           Search& search,
                           Known known) const {
  const Box& box = levels_[level][place];
  const Vec3 low(box.low[0], box.low[1], box.low[2]);
  const Vec3 high(box.high[0], box.high[1], box.high[2]);
  if (!search.enters(known, 0.5 * (low + high), 0.5 * (high - low), box.cone)) {
    return;
  }
  const std::size_t below = level > 0 ? levels_[level - 1].size() : order_.size();
  const std::size_t end = std::min(below, (place + 1) * parts);
  for (std::size_t i = place * parts; i < end; ++i) {
    if (level > 0) {
      searchIn(level - 1, i, search, known);
    } else {
      search.visit(known, order_[i], cones_[i]);
    }
  }
}

}  // namespace arelem::geometry
