#include "runtime/geometry/shapes.h"

#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::geometry {

namespace {
Vec3 triple(std::span<const double> canon, std::size_t first) {
  return {canon[first], canon[first + 1], canon[first + 2]};
}

/// What canonical numbers must be divided by so that a direction of this length becomes a unit
/// vector. Definitions make unit vectors; only canonical input may hold others. Of a null direction
/// the result is not finite.
double divisor(double length) {
  return std::abs(length - 1.0) <= tolerance::rounding ? 1.0 : length;
}

Vec3 unitTriple(std::span<const double> canon, std::size_t first) {
  const Vec3 direction = triple(canon, first);
  return direction / divisor(direction.norm());
}
}  // namespace

Point Point::of(std::span<const double> canon) {
  return {triple(canon, 0)};
}
Canon Point::canon() const {
  return {at.x(), at.y(), at.z()};
}

Line Line::of(std::span<const double> canon) {
  const Vec2 normal(canon[0], canon[1]);
  const double length = divisor(normal.norm());
  return {normal / length, canon[3] / length};
}
Canon Line::canon() const {
  return {normal.x(), normal.y(), 0.0, distance};
}

Plane Plane::of(std::span<const double> canon) {
  const Vec3 normal = triple(canon, 0);
  const double length = divisor(normal.norm());
  return {normal / length, canon[3] / length};
}
Canon Plane::canon() const {
  return {normal.x(), normal.y(), normal.z(), distance};
}

Circle Circle::of(std::span<const double> canon) {
  return {triple(canon, 0), canon[6]};
}
Canon Circle::canon() const {
  return {center.x(), center.y(), center.z(), 0.0, 0.0, 1.0, radius};
}

Cylinder Cylinder::of(std::span<const double> canon) {
  return {triple(canon, 0), unitTriple(canon, 3), canon[6]};
}
Canon Cylinder::canon() const {
  return {point.x(), point.y(), point.z(), axis.x(), axis.y(), axis.z(), radius};
}

Cone Cone::of(std::span<const double> canon) {
  return {triple(canon, 0), unitTriple(canon, 3), canon[6]};
}
Canon Cone::canon() const {
  return {vertex.x(), vertex.y(), vertex.z(), axis.x(), axis.y(), axis.z(), cosine};
}

Sphere Sphere::of(std::span<const double> canon) {
  return {triple(canon, 0), canon[3]};
}
Canon Sphere::canon() const {
  return {center.x(), center.y(), center.z(), radius};
}

Torus Torus::of(std::span<const double> canon) {
  return {triple(canon, 0), unitTriple(canon, 3), canon[6], canon[7]};
}
Canon Torus::canon() const {
  return {center.x(), center.y(), center.z(), axis.x(), axis.y(), axis.z(), major, minor};
}

Quadric Quadric::of(std::span<const double> canon) {
  const double a = canon[0], b = canon[1], c = canon[2], d = canon[3];
  const double f = canon[4], g = canon[5], h = canon[6];
  const double p = canon[7], q = canon[8], r = canon[9];
  Quadric result;
  result.matrix << a, h, g, p,  //
      h, b, f, q,               //
      g, f, c, r,               //
      p, q, r, d;
  return result;
}
Canon Quadric::canon() const {
  const auto& m = matrix;
  return {m(0, 0), m(1, 1), m(2, 2), m(3, 3), m(1, 2), m(0, 2), m(0, 1), m(0, 3), m(1, 3), m(2, 3)};
}
double Quadric::value(const Vec3& place) const {
  const Eigen::Vector4d x = place.homogeneous();
  return x.dot(matrix * x);
}
Vec3 Quadric::gradient(const Vec3& place) const {
  return 2.0 * (matrix * place.homogeneous()).head<3>();
}

Direction Direction::of(std::span<const double> canon) {
  return {triple(canon, 0)};
}
Canon Direction::canon() const {
  return {components.x(), components.y(), components.z()};
}

Matrix Matrix::of(std::span<const double> canon) {
  Matrix result;
  for (int row = 0; row < 3; ++row) {
    const auto first = static_cast<std::size_t>(4 * row);
    result.linear.row(row) = triple(canon, first).transpose();
    result.translation(row) = canon[first + 3];
  }
  return result;
}
Canon Matrix::canon() const {
  Canon result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result.push_back(linear(row, column));
    }
    result.push_back(translation(row));
  }
  return result;
}
Matrix Matrix::operator*(const Matrix& first) const {
  return {linear * first.linear, linear * first.translation + translation};
}

}  // namespace arelem::geometry
