#include "runtime/geometry/triangle_tree.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "runtime/geometry/place_order.h"

namespace arelem::geometry {

namespace {
/// Triangles of a leaf at most.
constexpr std::uint32_t ofLeaf = 4;
/// Boxes of this many triangles at most have a plane that covers them.
constexpr std::uint32_t covered = 512;
}  // namespace

OnTriangle nearestOn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return {a, Feature::vertex0};
  }
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0.0 && d4 <= d3) {
    return {b, Feature::vertex1};
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return {a + d1 / (d1 - d3) * ab, Feature::edge0};
  }
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0.0 && d5 <= d6) {
    return {c, Feature::vertex2};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return {a + d2 / (d2 - d6) * ac, Feature::edge2};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), Feature::edge1};
  }
  const double sum = va + vb + vc;
  return {a + vb / sum * ab + vc / sum * ac, Feature::face};
}

/// Divides the order where the highest bit in which its keys differ changes.
class TriangleTree::Builder {
 public:
  Builder(TriangleTree& tree, const TriangleMesh& mesh, PlaceOrder order)
      : tree_(tree), mesh_(mesh), keys_(std::move(order.keys)) {
    tree_.order_ = std::move(order.triangles);
    tree_.boxes_.reserve(2 * keys_.size());
    tree_.boxes_.resize(1);
    build(0, 0, static_cast<std::uint32_t>(keys_.size()));
    tree_.boxes_.shrink_to_fit();
  }

 private:
  void build(std::size_t place, std::uint32_t begin, std::uint32_t end) {
    if (end - begin <= ofLeaf) {
      tree_.boxes_[place] = leaf(begin, end);
      tree_.boxes_[place].cover = cover(begin, end);
      return;
    }
    const std::size_t child = tree_.boxes_.size();
    tree_.boxes_.resize(child + 2);
    const std::uint32_t middle = division(begin, end);
    build(child, begin, middle);
    build(child + 1, middle, end);
    Box box = tree_.boxes_[child];
    const Box& other = tree_.boxes_[child + 1];
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], other.low[k]);
      box.high[k] = std::max(box.high[k], other.high[k]);
    }
    box.first = static_cast<std::uint32_t>(child);
    box.count = 0;
    box.cover = end - begin <= covered ? cover(begin, end) : Cover{};
    tree_.boxes_[place] = box;
  }

  [[nodiscard]] Box leaf(std::uint32_t begin, std::uint32_t end) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    Box box{{none, none, none}, {-none, -none, -none}, begin, end - begin};
    for (std::uint32_t i = begin; i < end; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Vec3& v = mesh_.corner(tree_.order_[i], corner);
        for (std::size_t k = 0; k < 3; ++k) {
          box.low[k] = std::min(box.low[k], v[static_cast<Eigen::Index>(k)]);
          box.high[k] = std::max(box.high[k], v[static_cast<Eigen::Index>(k)]);
        }
      }
    }
    return box;
  }

  /// Square to the sum of all areas.
  [[nodiscard]] Cover cover(std::uint32_t begin, std::uint32_t end) const {
    Vec3 sum = Vec3::Zero();
    for (std::uint32_t i = begin; i < end; ++i) {
      const Vec3& a = mesh_.corner(tree_.order_[i], 0);
      const Vec3 ab = mesh_.corner(tree_.order_[i], 1) - a;
      const Vec3 ac = mesh_.corner(tree_.order_[i], 2) - a;
      sum += ab.cross(ac);
    }
    const double norm = sum.norm();
    Cover result;
    if (!(norm > 0.0)) {
      return result;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      result.normal[k] = static_cast<float>(sum[static_cast<Eigen::Index>(k)] / norm);
    }
    const Vec3 normal(result.normal[0], result.normal[1], result.normal[2]);
    result.most = -std::numeric_limits<double>::infinity();
    for (std::uint32_t i = begin; i < end; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        result.most = std::max(result.most, normal.dot(mesh_.corner(tree_.order_[i], corner)));
      }
    }
    return result;
  }

  [[nodiscard]] std::uint32_t division(std::uint32_t begin, std::uint32_t end) const {
    const std::uint64_t differ = keys_[begin] ^ keys_[end - 1];
    if (differ == 0) {
      return begin + (end - begin) / 2;
    }
    const std::uint64_t bit = std::bit_floor(differ);
    const auto first = keys_.begin();
    return static_cast<std::uint32_t>(
        std::partition_point(first + begin, first + end,
                             [&](std::uint64_t key) { return (key & bit) == 0; }) -
        first);
  }

  TriangleTree& tree_;
  const TriangleMesh& mesh_;
  std::vector<std::uint64_t> keys_;
};

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  Builder(*this, mesh, PlaceOrder::of(mesh));
}

double TriangleTree::Box::squaredDistance(const Vec3& p) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = p[static_cast<Eigen::Index>(k)];
    const double beside = std::max({low[k] - x, x - high[k], 0.0});
    sum += beside * beside;
  }
  return sum;
}

/// The nearer box first, so that the others are too far off.
std::size_t TriangleTree::nearest(const TriangleMesh& mesh, const Vec3& p, int guess) const {
  std::size_t found = 0;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t i) {
    const Vec3 on = nearestOn(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), p).point;
    const double squared = (on - p).squaredNorm();
    if (squared < least || (squared == least && i < found)) {
      least = squared;
      found = i;
    }
  };
  if (guess >= 0) {
    look(static_cast<std::size_t>(guess));
  }
  struct Later {
    std::uint32_t box;
    double squared;
  };
  std::array<Later, deepest> later;
  std::size_t waiting = 1;
  later[0] = {0, boxes_[0].squaredDistance(p)};
  while (waiting > 0) {
    const auto [place, squared] = later[--waiting];
    if (!(squared <= least)) {
      continue;
    }
    const Box& box = boxes_[place];
    if (box.count == 0) {
      const double first = boxes_[box.first].squaredDistance(p);
      const double second = boxes_[box.first + 1].squaredDistance(p);
      const bool swap = second < first;
      later[waiting++] = swap ? Later{box.first, first} : Later{box.first + 1, second};
      later[waiting++] = swap ? Later{box.first + 1, second} : Later{box.first, first};
    }
    for (std::uint32_t i = 0; i < box.count; ++i) {
      look(order_[box.first + i]);
    }
  }
  return found;
}

}  // namespace arelem::geometry
