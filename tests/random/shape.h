#pragma once
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "tests/random/similarity.h"

/// Surfaces of random scenes, as numbers that a similarity moves and as APT definitions.
namespace arelem::scenes {

struct PlaneShape {
  Vec3 normal;  ///< of any length
  double offset = 0.0;
};
struct SphereShape {
  Vec3 center;
  double radius = 1.0;
};
struct CylinderShape {
  Vec3 point, axis;
  double radius = 1.0;
};
struct ConeShape {
  Vec3 apex, axis;
  double degrees = 10.0;  ///< half the opening
};
struct TorusShape {
  Vec3 center, axis;
  double major = 2.0, minor = 1.0;
};
/// (p, 1) . form (p, 1) = 0.
struct QuadricShape {
  Eigen::Matrix4d form;
};
struct TabulatedShape {
  Vec3 direction;
  std::vector<Vec3> points;
};
/// Between the curves that two cylinders have in the planes of three points each.
struct RuledShape {
  std::array<CylinderShape, 2> carriers;
  std::array<std::array<Vec3, 3>, 2> points;
};
/// POLCON: unit directions, origin, and the coefficients of A to P by powers of d.
struct PolyconicShape {
  std::array<Vec3, 3> frame;
  Vec3 origin;
  double thick = 0.0, cb = 0.0, pb = 0.0;
  std::array<std::vector<double>, 7> rows;
};
struct MeshShape {
  std::vector<std::array<Vec3, 3>> triangles;
};
using Shape = std::variant<PlaneShape,
                           SphereShape,
                           CylinderShape,
                           ConeShape,
                           TorusShape,
                           QuadricShape,
                           TabulatedShape,
                           RuledShape,
                           PolyconicShape,
                           MeshShape>;

/// Numbers as APT reads them back, with commas between.
[[nodiscard]] std::string written(double value);
[[nodiscard]] std::string written(const Vec3& v);

/// The APT definition of a shape moved. A mesh is read from `file`.
[[nodiscard]] std::string definition(const Shape& shape,
                                     const Similarity& move,
                                     const std::string& file);
/// The STL text of a mesh moved; mirrors keep the outside outside.
[[nodiscard]] std::string stl(const MeshShape& mesh, const Similarity& move);

}  // namespace arelem::scenes
