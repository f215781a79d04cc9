#pragma once
#include <optional>
#include <vector>

#include "runtime/geometry/triangle_mesh.h"
#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

/// A plane n . p = level that cuts a surface; with `half`, only where half . (p - place) is
/// positive.
struct CuttingPlane {
  Vec3 normal = Vec3::UnitX();
  double level = 0.0;
  std::optional<Vec3> half;
  Vec3 place = Vec3::Zero();
};

/// The pieces of a line on the positive side of the plane's half; the line where it has none.
[[nodiscard]] std::vector<SurfaceLine> onItsSide(const SurfaceLine& line,
                                                 const CuttingPlane& plane);

/// A mesh to be sprayed, mm. The normal at a corner is the mean of the triangles about it, weighted
/// with their angles there; those beyond a crease of 40 degrees do not count. Straight between the
/// corners.
class MeshSurface {
 public:
  explicit MeshSurface(geometry::TriangleMesh mesh, bool flipped);

  /// What planes keep of it, bent as it was.
  [[nodiscard]] MeshSurface cutBy(const std::vector<HalfSpace>& keep) const;

  [[nodiscard]] const geometry::TriangleMesh& mesh() const { return mesh_; }
  [[nodiscard]] double area() const;
  /// Twice the area of a triangle along its normal.
  [[nodiscard]] Vec3 spanned(std::size_t triangle) const;
  /// Mean direction of the normals; zero of a closed body.
  [[nodiscard]] Vec3 meanNormal() const { return mean_; }
  /// Lowest and highest value of n . p.
  [[nodiscard]] std::pair<double, double> range(const Vec3& normal) const;

  /// The sections by planes, points a chord tolerance apart, pieces of one plane one after another.
  [[nodiscard]] std::vector<SurfaceLine> sections(const std::vector<CuttingPlane>& planes,
                                                  double chord) const;
  /// Smallest radius of curvature along sections, measured over pieces of this length; none where
  /// they are straight.
  [[nodiscard]] std::optional<double> smallestRadius(const std::vector<CuttingPlane>& planes,
                                                     double piece) const;
  /// The same where they bend towards the normal.
  [[nodiscard]] std::optional<double> smallestHollow(const std::vector<CuttingPlane>& planes,
                                                     double piece) const;

  /// A place inside a triangle, by its shares of the three corners.
  [[nodiscard]] LinePoint at(std::size_t triangle, const Vec3& shares) const;

 private:
  [[nodiscard]] Vec3 meanOfAll() const;
  [[nodiscard]] double angleAt(std::size_t triangle, std::size_t corner) const;
  [[nodiscard]] std::vector<SurfaceLine> cut(const CuttingPlane& plane) const;
  [[nodiscard]] std::optional<double> bend(const std::vector<CuttingPlane>& planes,
                                           double piece,
                                           bool hollowOnly) const;

  geometry::TriangleMesh mesh_;
  std::vector<std::array<Vec3, 3>> normals_;  // at the corners of each triangle
  Vec3 mean_ = Vec3::Zero();
};

}  // namespace arelem::spray
