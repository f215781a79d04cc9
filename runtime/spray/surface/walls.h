#pragma once
#include <optional>

#include "runtime/geometry/triangle_tree.h"
#include "runtime/spray/surface/patch.h"

namespace arelem::spray {

/// What a gun may run into: the triangles of the work, mm.
class Walls {
 public:
  explicit Walls(const geometry::TriangleMesh& mesh);
  /// The whole range of the parameters of a patch, in triangles.
  [[nodiscard]] static Walls of(const Patch& patch);

  /// How far from `from`, on the straight way to `to`, lies the first triangle that the way goes
  /// through; none where it goes through none. To touch one is not to go through it.
  [[nodiscard]] std::optional<double> between(const Vec3& from, const Vec3& to) const;
  /// The place on the triangles that is nearest to one.
  [[nodiscard]] Vec3 nearest(const Vec3& place) const;
  /// Distance of the nearest triangle, mm.
  [[nodiscard]] double from(const Vec3& place) const { return (nearest(place) - place).norm(); }
  /// Triangles lie as far beside the surface that they stand for, mm; 0 of a mesh.
  [[nodiscard]] double blur() const { return blur_; }
  [[nodiscard]] const geometry::TriangleMesh& mesh() const { return mesh_; }

 private:
  geometry::TriangleMesh mesh_;
  geometry::TriangleTree tree_;
  double blur_ = 0.0;
};

}  // namespace arelem::spray
