#include "runtime/geometry/kinds/quadric.h"

#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace arelem::surface {

namespace {
constexpr int newtonLimit = 40;
constexpr int approachLimit = 60;

/// Newton on q - p + m grad F(q) = 0, F(q) = 0 from a point near the surface.
std::optional<Vec3> refine(const Quadric& s, const Vec3& p, Vec3 q) {
  const Vec3 start = s.gradient(q);
  double multiplier = start.squaredNorm() > 0.0 ? (p - q).dot(start) / start.squaredNorm() : 0.0;
  for (int i = 0; i < newtonLimit; ++i) {
    const Vec3 gradient = s.gradient(q);
    Eigen::Matrix4d jacobian = Eigen::Matrix4d::Zero();
    jacobian.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() + 2.0 * multiplier * s.matrix;
    jacobian.topRightCorner<3, 1>() = gradient;
    jacobian.bottomLeftCorner<1, 3>() = gradient.transpose();
    Eigen::Vector4d residual;
    residual.head<3>() = q - p + multiplier * gradient;
    residual[3] = s.value(q);
    const Eigen::Vector4d step = jacobian.partialPivLu().solve(residual);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    q -= step.head<3>();
    multiplier -= step[3];
    if (step.head<3>().norm() <= 1e-15 * (1.0 + q.norm())) {
      return q;
    }
  }
  return std::nullopt;
}

/// Walks from p down the gradient until F is nearly zero: the start where there is no hint.
Vec3 approach(const Quadric& s, const Vec3& p) {
  Vec3 q = p;
  for (int i = 0; i < approachLimit; ++i) {
    const Vec3 gradient = s.gradient(q);
    const double squared = gradient.squaredNorm();
    if (squared <= 0.0) {
      q += Vec3(1e-3, 2e-3, 3e-3) * (1.0 + q.norm());
      continue;
    }
    const Vec3 step = s.value(q) / squared * gradient;
    q -= step;
    if (step.norm() <= 1e-6 * (1.0 + q.norm())) {
      break;
    }
  }
  return q;
}
/// Nearest of the feet reached from several starts: gradient descent, and where the principal lines
/// through p pierce the surface. Used where no hint tells which sheet or side is meant.
std::optional<Vec3> nearestFoot(const Quadric& s, const Vec3& p) {
  std::optional<Vec3> best = refine(s, p, approach(s, p));
  const auto consider = [&](const Vec3& start) {
    const auto q = refine(s, p, start);
    if (q && (!best || (*q - p).squaredNorm() < (*best - p).squaredNorm())) {
      best = q;
    }
  };
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(s.matrix);
  for (int i = 0; i < 3; ++i) {
    const Vec3 d = eigen.eigenvectors().col(i);
    const double a = d.dot(s.matrix * d);
    const double b = d.dot(s.matrix * p + s.linear);
    const double c = s.value(p);
    const double disc = b * b - a * c;
    if (disc >= 0.0 && a != 0.0) {
      consider(p + (-b + std::sqrt(disc)) / a * d);
      consider(p + (-b - std::sqrt(disc)) / a * d);
    }
  }
  return best;
}
}  // namespace

Foot Quadric::foot(const Vec3& p, Hint& hint) const {
  std::optional<Vec3> q = hint.valid ? refine(*this, p, hint.point) : std::nullopt;
  if (!q) {
    q = nearestFoot(*this, p);
  }
  const Vec3 found = q ? *q : approach(*this, p);
  hint = {true, found};
  const Vec3 outward = gradient(found).normalized();
  const Vec3 w = p - found;
  return {w.dot(outward), outward};
}

double Quadric::bend(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  const Vec3 grad = gradient(hint.point);
  const double length = grad.norm();
  if (!hint.valid || length <= 0.0) {
    return 0.0;
  }
  const Vec3 e1 = foot.normal.unitOrthogonal();
  const Vec3 e2 = foot.normal.cross(e1);
  const auto curvature = [&](const Vec3& a, const Vec3& b) {
    return 2.0 * a.dot(matrix * b) / length;
  };
  Eigen::Matrix2d shape;
  shape << curvature(e1, e1), curvature(e1, e2), curvature(e1, e2), curvature(e2, e2);
  // The parallel surface at distance d has the shape operator (1 + d S)^-1 S.
  const Eigen::Matrix2d parallel =
      (Eigen::Matrix2d::Identity() + foot.distance * shape).inverse() * shape;
  const Eigen::Vector2d along(e1.dot(t), e2.dot(t));
  return along.dot(parallel * along);
}

Vec3 Quadric::findGeneratrix() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix);
  const double scale = eigen.eigenvalues().cwiseAbs().maxCoeff();
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = eigen.eigenvectors().col(i);
    if (std::abs(eigen.eigenvalues()[i]) <= 1e-14 * scale &&
        std::abs(linear.dot(axis)) <= 1e-14 * linear.norm()) {
      return axis;
    }
  }
  return Vec3::Zero();
}

}  // namespace arelem::surface
