#pragma once
#include <span>
#include <vector>

#include <Eigen/Core>

#include "ir/geometry/entity.h"
#include "ir/space/vector.h"

/// Typed views of canonical forms (layouts: ir/geometry/entity.h). Each `of` reads the values of an
/// entity of its type, `canon` writes them. Lengths in the part unit; normals and axes are unit
/// vectors: `of` divides by their length, which differs from 1 only after canonical input.
namespace arelem::geometry {

using Vec2 = Eigen::Vector2d;
using Canon = std::vector<double>;

struct Point {
  Vec3 at = Vec3::Zero();
  [[nodiscard]] static Point of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

/// The vertical plane normal . (x, y) = distance.
struct Line {
  Vec2 normal{0.0, 1.0};
  double distance = 0.0;
  [[nodiscard]] static Line of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  /// Signed distance of a place, positive on the side the normal points to.
  [[nodiscard]] double height(const Vec2& place) const { return normal.dot(place) - distance; }
  /// The normal turned by 90 degrees: the direction P1 -> P2 of a line defined by two points.
  [[nodiscard]] Vec2 along() const { return {-normal.y(), normal.x()}; }
};

/// normal . x = distance. Also reads a LINE, whose third component is 0.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double distance = 0.0;
  [[nodiscard]] static Plane of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  [[nodiscard]] double height(const Vec3& place) const { return normal.dot(place) - distance; }
};

/// A vertical cylinder; z of the center is 0 unless canonical input says otherwise.
struct Circle {
  Vec3 center = Vec3::Zero();
  double radius = 0.0;
  [[nodiscard]] static Circle of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  [[nodiscard]] Vec2 middle() const { return center.head<2>(); }
};

/// Also reads a CIRCLE, whose axis is z.
struct Cylinder {
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius = 0.0;
  [[nodiscard]] static Cylinder of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

/// One nappe, on the side the axis points to.
struct Cone {
  Vec3 vertex = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double cosine = 1.0;  ///< of the half angle
  [[nodiscard]] static Cone of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 0.0;
  [[nodiscard]] static Sphere of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

struct Torus {
  Vec3 center = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double major = 0.0;  ///< radius of the center circle of the tube
  double minor = 0.0;  ///< radius of the tube
  [[nodiscard]] static Torus of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

/// ELLIPS, HYPERB, GCONIC, LCONIC and QADRIC: x4' Q x4 = 0 with x4 = (x, y, z, 1) and the symmetric
/// Q = [a h g p; h b f q; g f c r; p q r d].
struct Quadric {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  [[nodiscard]] static Quadric of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;  ///< a b c d f g h p q r
  [[nodiscard]] double value(const Vec3& place) const;
  [[nodiscard]] Vec3 gradient(const Vec3& place) const;
};

struct Direction {
  Vec3 components = Vec3::Zero();
  [[nodiscard]] static Direction of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
};

/// p' = linear p + translation.
struct Matrix {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 translation = Vec3::Zero();
  [[nodiscard]] static Matrix of(std::span<const double> canon);
  [[nodiscard]] Canon canon() const;
  [[nodiscard]] Vec3 apply(const Vec3& place) const { return linear * place + translation; }
  /// The factor on the right acts first.
  [[nodiscard]] Matrix operator*(const Matrix& first) const;
};

}  // namespace arelem::geometry
