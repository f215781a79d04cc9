#include "runtime/spray/surface/walls.h"

#include <algorithm>
#include <cmath>

#include "ir/space/spray_tolerance.h"
#include "runtime/spray/surface/patch_mesh.h"

namespace arelem::spray {

namespace {
constexpr std::uint32_t steps = 96;  // of each parameter of a patch

/// The first triangle on a straight way.
class FirstCrossing {
 public:
  FirstCrossing(const geometry::TriangleMesh& mesh, const Vec3& from, const Vec3& to)
      : mesh_(mesh), from_(from), way_(to - from) {}

  [[nodiscard]] bool enters(const Vec3& center, const Vec3& half) {
    double first = 0.0;
    double last = share_;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double low = center[i] - half[i] - from_[i];
      const double high = center[i] + half[i] - from_[i];
      if (way_[i] == 0.0) {
        if (low > 0.0 || high < 0.0) {
          return false;
        }
        continue;
      }
      const double a = low / way_[i];
      const double b = high / way_[i];
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    return first <= last;
  }

  void visit(std::size_t t) {
    const Vec3& a = mesh_.corner(t, 0);
    const Vec3 normal = (mesh_.corner(t, 1) - a).cross(mesh_.corner(t, 2) - a).normalized();
    const double before = normal.dot(from_ - a);
    const double behind = normal.dot(from_ + way_ - a);
    if (!(before * behind < 0.0) ||
        std::min(std::abs(before), std::abs(behind)) <= tolerance::wallTouch) {
      return;
    }
    const double share = before / (before - behind);
    const Vec3 place = from_ + share * way_;
    for (std::size_t k = 0; k < 3; ++k) {
      // A way through an edge goes through one of its triangles at least.
      const Vec3& corner = mesh_.corner(t, k);
      const Vec3 edge = mesh_.corner(t, (k + 1) % 3) - corner;
      if (edge.cross(place - corner).dot(normal) < -tolerance::wallTouch * edge.norm()) {
        return;
      }
    }
    share_ = std::min(share_, share);
    found_ = true;
  }

  [[nodiscard]] std::optional<double> distance() const {
    return found_ ? std::optional(share_ * way_.norm()) : std::nullopt;
  }

 private:
  const geometry::TriangleMesh& mesh_;
  Vec3 from_, way_;
  double share_ = 1.0;
  bool found_ = false;
};
}  // namespace

Walls::Walls(const geometry::TriangleMesh& mesh) : mesh_(mesh), tree_(mesh) {}

Walls Walls::of(const Patch& patch) {
  const PatchMesh triangles = meshOf(patch, steps);
  Walls walls(triangles.mesh);
  walls.blur_ = triangles.blur;
  return walls;
}

Vec3 Walls::nearest(const Vec3& place) const {
  const std::size_t t = tree_.nearest(mesh_, place, -1);
  return geometry::nearestOn(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), place)
      .point;
}

std::optional<double> Walls::between(const Vec3& from, const Vec3& to) const {
  FirstCrossing search(mesh_, from, to);
  tree_.search(search);
  return search.distance();
}

}  // namespace arelem::spray
