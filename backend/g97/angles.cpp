#include "backend/g97/angles.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "ir/space/tolerance.h"

namespace arelem::backend::g97 {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

Matrix3 turn(double degrees, const Vec3& about) {
  return Eigen::AngleAxisd(degrees * radian, about).toRotationMatrix();
}

double degrees(double y, double x) {
  const double angle = std::atan2(y, x) / radian;
  return angle <= -180.0 ? 180.0 : angle + 0.0;
}

/// The tool's frame: z along the axis, x as near to the side as square to the axis allows.
std::optional<Matrix3> frameOf(const Vec3& axis, const Vec3& side) {
  const Vec3 x = side - side.dot(axis) * axis;
  if (!(x.norm() > tolerance::nullDirection)) {
    return std::nullopt;
  }
  Matrix3 frame;
  frame.col(0) = x.normalized();
  frame.col(2) = axis;
  frame.col(1) = axis.cross(frame.col(0));
  return frame;
}

Angles movingAngles(const Matrix3& m) {
  const double q = degrees(m(0, 2), std::hypot(m(0, 0), m(0, 1)));
  if (std::hypot(m(0, 0), m(0, 1)) <= tolerance::symmetric) {
    return {degrees(m(2, 1), m(1, 1)), q, 0.0};
  }
  return {degrees(-m(1, 2), m(2, 2)), q, degrees(-m(0, 1), m(0, 0))};
}

Angles fixedAngles(const Matrix3& m) {
  const double q = degrees(-m(2, 0), std::hypot(m(0, 0), m(1, 0)));
  if (std::hypot(m(0, 0), m(1, 0)) <= tolerance::symmetric) {
    return {degrees(-m(1, 2), m(1, 1)), q, 0.0};
  }
  return {degrees(m(2, 1), m(2, 2)), q, degrees(m(1, 0), m(0, 0))};
}
}  // namespace

Matrix3 matrixOf(const Angles& a, Reading reading) {
  const Matrix3 x = turn(a.p, Vec3::UnitX());
  const Matrix3 y = turn(a.q, Vec3::UnitY());
  const Matrix3 z = turn(a.r, Vec3::UnitZ());
  return reading == Reading::moving ? Matrix3(x * y * z) : Matrix3(z * y * x);
}

Angles anglesOf(const Vec3& axis, const std::optional<Vec3>& side, Reading reading) {
  const Vec3 n = axis.normalized();
  if (side) {
    if (const std::optional<Matrix3> frame = frameOf(n, *side)) {
      return reading == Reading::moving ? movingAngles(*frame) : fixedAngles(*frame);
    }
  }
  // A component of rounding size is none: it would turn the hand by a quarter at a pole.
  const auto plain = [](double v) { return std::abs(v) <= tolerance::symmetric ? 0.0 : v; };
  const double a = plain(n.x());
  const double b = plain(n.y());
  const double c = plain(n.z());
  if (reading == Reading::moving) {
    return {b == 0.0 && c == 0.0 ? 0.0 : degrees(-b, c), degrees(a, std::hypot(b, c)), 0.0};
  }
  // Rz(0) Ry(Q) Rx(P) z = (sin Q cos P, -sin P, cos Q cos P): |Q| may pass 90 here.
  return {degrees(-b, std::hypot(a, c)), a == 0.0 && c == 0.0 ? 0.0 : degrees(a, c), 0.0};
}

std::optional<Angles> sourceAngles(const Vec3& axis) {
  if (!(axis.z() > 0.0)) {
    return std::nullopt;
  }
  return Angles{-std::atan(axis.y() / axis.z()) / radian, std::atan(axis.x() / axis.z()) / radian,
                0.0};
}

}  // namespace arelem::backend::g97
