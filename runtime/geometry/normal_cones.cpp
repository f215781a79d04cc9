#include "runtime/geometry/normal_cones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::geometry {

namespace {
/// More than what rounding to single precision moves a unit vector.
constexpr double rounded = 1e-6;
/// A normal whose direction is known worse than this, by the rounding of products of coordinates,
/// tells nothing.
constexpr double exactEnough = 1e-7;
constexpr double ulps = 16.0 * std::numeric_limits<double>::epsilon();
/// The highest level has no more boxes.
constexpr std::size_t fewest = 8;

/// A cone in double precision, while it is made.
struct Spread {
  Vec3 axis = Vec3::Zero();
  double radius = std::numeric_limits<double>::infinity();

  explicit Spread(const Vec3& sum) {
    const double norm = sum.norm();
    if (norm > 0.0) {
      axis = sum / norm;
      radius = 0.0;
    }
  }
  void cover(const Vec3& direction, double around) {
    radius = std::max(radius, (direction - axis).norm() + around);
  }
  [[nodiscard]] NormalCones::Cone rounded() const {
    NormalCones::Cone cone;
    const double most = radius + arelem::geometry::rounded;
    if (most < NormalCones::any) {
      cone.axis = {static_cast<float>(axis.x()), static_cast<float>(axis.y()),
                   static_cast<float>(axis.z())};
      cone.radius = static_cast<float>(most);
    }
    return cone;
  }
};

bool isExact(const TriangleMesh& mesh, std::size_t i) {
  const Vec3 u = mesh.corner(i, 1) - mesh.corner(i, 0);
  const Vec3 v = mesh.corner(i, 2) - mesh.corner(i, 0);
  const double size = mesh.corner(i, 0).cwiseAbs().maxCoeff() + u.norm() + v.norm();
  return ulps * size * (u.norm() + v.norm()) <= exactEnough * u.cross(v).norm();
}

float below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}
}  // namespace

NormalCones::NormalCones(const TriangleMesh& mesh,
                         std::span<const Vec3> normals,
                         const std::vector<bool>& atBorder,
                         std::span<const std::uint32_t> order)
    : order_(order.begin(), order.end()) {
  addTriangles(mesh, normals, atBorder);
  while (levels_.back().size() > fewest) {
    addLevel();
  }
}

/// A triangle's cone covers those of its three vertices.
void NormalCones::addTriangles(const TriangleMesh& mesh,
                               std::span<const Vec3> normals,
                               const std::vector<bool>& atBorder) {
  std::vector<Vec3> sums(mesh.vertices.size(), Vec3::Zero());
  std::vector<double> radii(mesh.vertices.size(), 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t v : mesh.triangles[i]) {
      sums[v] += normals[i];
    }
  }
  std::vector<Spread> spreads;
  spreads.reserve(sums.size());
  for (const Vec3& sum : sums) {
    spreads.emplace_back(sum);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const double around = isExact(mesh, i) ? exactEnough : std::numeric_limits<double>::infinity();
    for (const std::uint32_t v : mesh.triangles[i]) {
      spreads[v].cover(normals[i], atBorder[v] ? std::numeric_limits<double>::infinity() : around);
    }
  }
  cones_.reserve(order_.size());
  for (const std::uint32_t i : order_) {
    const auto& t = mesh.triangles[i];
    Spread spread(spreads[t[0]].axis + spreads[t[1]].axis + spreads[t[2]].axis);
    for (const std::uint32_t v : t) {
      spread.cover(spreads[v].axis, spreads[v].radius);
    }
    cones_.push_back(spread.rounded());
  }
  std::vector<Box>& boxes = levels_.emplace_back();
  for (std::size_t begin = 0; begin < order_.size(); begin += parts) {
    const std::size_t end = std::min(begin + parts, order_.size());
    Vec3 low = mesh.corner(order_[begin], 0);
    Vec3 high = low;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        low = low.cwiseMin(mesh.corner(order_[i], k));
        high = high.cwiseMax(mesh.corner(order_[i], k));
      }
      sum += cones_[i].direction();
    }
    Spread spread(sum);
    for (std::size_t i = begin; i < end; ++i) {
      spread.cover(cones_[i].direction(), cones_[i].radius);
    }
    boxes.push_back({{below(low.x()), below(low.y()), below(low.z())},
                     {above(high.x()), above(high.y()), above(high.z())},
                     spread.rounded()});
  }
}

void NormalCones::addLevel() {
  const std::vector<Box>& last = levels_.back();
  std::vector<Box> boxes;
  for (std::size_t begin = 0; begin < last.size(); begin += parts) {
    const std::size_t end = std::min(begin + parts, last.size());
    Box box = last[begin];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], last[i].low[k]);
        box.high[k] = std::max(box.high[k], last[i].high[k]);
      }
      sum += last[i].cone.direction();
    }
    Spread spread(sum);
    for (std::size_t i = begin; i < end; ++i) {
      spread.cover(last[i].cone.direction(), last[i].cone.radius);
    }
    box.cone = spread.rounded();
    boxes.push_back(box);
  }
  levels_.push_back(std::move(boxes));
}

}  // namespace arelem::geometry
