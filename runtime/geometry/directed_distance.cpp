#include "runtime/geometry/directed_distance.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/geometry/polynomial.h"

namespace arelem::geometry {

void CrossingChoice::consider(double s) {
  if (std::abs(s) <= tolerance::zeroDistance) {
    s = 0.0;
  }
  if (!nearest_ || std::abs(s) <= std::abs(*nearest_)) {
    nearest_ = s;
  }
  if (s >= 0.0 && (!ahead_ || s < *ahead_)) {
    ahead_ = s;
  }
}

std::optional<double> CrossingChoice::result() const {
  switch (which_) {
    case Crossing::nearest:
      return nearest_;
    case Crossing::ahead:
      return ahead_;
    case Crossing::aheadElseNearest:
      break;
  }
  return ahead_ ? ahead_ : nearest_;
}

namespace {
/// Calls `use` with each root, ascending.
template <class Use>
void quadraticRoots(double a, double b, double c, Use use) {
  if (std::abs(a) <= tolerance::grazing) {
    if (std::abs(b) > tolerance::grazing) {
      use(-c / (2.0 * b));
    }
    return;
  }
  const double discriminant = b * b - a * c;
  if (std::abs(discriminant) <= tolerance::doubleRoot * a * a) {
    use(-b / a);
    return;
  }
  if (discriminant < 0.0) {
    return;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double one = q / a;
  const double two = c / q;
  use(std::min(one, two));
  use(std::max(one, two));
}
}  // namespace

void considerQuadratic(double a, double b, double c, CrossingChoice& choice) {
  quadraticRoots(a, b, c, [&](double s) { choice.consider(s); });
}

std::optional<double> directedDistance(const Plane& plane,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  const double sine = plane.normal.dot(direction);
  if (std::abs(sine) <= tolerance::grazing) {
    return std::nullopt;
  }
  CrossingChoice choice(which);
  choice.consider(-plane.height(from) / sine);
  return choice.result();
}

std::optional<double> directedDistance(const Sphere& sphere,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  const Vec3 w = from - sphere.center;
  CrossingChoice choice(which);
  considerQuadratic(direction.squaredNorm(), w.dot(direction),
                    w.squaredNorm() - sphere.radius * sphere.radius, choice);
  return choice.result();
}

std::optional<double> directedDistance(const Cylinder& cylinder,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  // Components across the axis; the differences of squares of the report would cancel far from the
  // origin.
  const Vec3 w = (from - cylinder.point).cross(cylinder.axis);
  const Vec3 d = direction.cross(cylinder.axis);
  CrossingChoice choice(which);
  if (d.squaredNorm() > tolerance::grazing) {
    considerQuadratic(d.squaredNorm(), d.dot(w),
                      w.squaredNorm() - cylinder.radius * cylinder.radius, choice);
  }
  return choice.result();
}

std::optional<double> directedDistance(const Cone& cone,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  const Vec3 w = from - cone.vertex;
  const double k2 = cone.cosine * cone.cosine;
  const double dt = direction.dot(cone.axis);
  const double wt = w.dot(cone.axis);
  CrossingChoice choice(which);
  quadraticRoots(dt * dt - k2 * direction.squaredNorm(), dt * wt - k2 * direction.dot(w),
                 wt * wt - k2 * w.squaredNorm(), [&](double s) {
                   if (wt + s * dt >= 0.0) {
                     choice.consider(s);
                   }
                 });
  return choice.result();
}

std::optional<double> directedDistance(const Quadric& quadric,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  const Eigen::Vector4d d(direction.x(), direction.y(), direction.z(), 0.0);
  const Eigen::Vector4d p = from.homogeneous();
  // The zero tests are for coefficients of size one; those of a quadric have any size.
  double size = quadric.matrix.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
  if (!(size > 0.0)) {
    size = quadric.matrix.topRightCorner<3, 1>().cwiseAbs().maxCoeff();
  }
  const Eigen::Vector4d qd = quadric.matrix * d / size;
  CrossingChoice choice(which);
  considerQuadratic(d.dot(qd), p.dot(qd), p.dot(quadric.matrix * p) / size, choice);
  return choice.result();
}

namespace {
/// The line w + lambda d in the interval's chord frame: along t = w.x + lambda d.x, across v = w.y
/// + lambda d.y. With the normal (-d.y, d.x) of the line: v(t) d.x - t d.y - (w.y d.x - w.x d.y) =
/// 0, a cubic in t.
void considerInterval(const TabulatedCylinder::Interval& interval,
                      const Vec2& from,
                      const Vec2& direction,
                      CrossingChoice& choice) {
  const Vec2 local = from - interval.start;
  const Vec2 w(local.dot(interval.along), local.dot(interval.across()));
  const Vec2 d(direction.dot(interval.along), direction.dot(interval.across()));
  // Where the line misses the rectangle of the interval, all its corners are on one side.
  const double offset = w.y() * d.x() - w.x() * d.y();
  const auto side = [&](double t, double v) { return v * d.x() - t * d.y() - offset; };
  const double corners[] = {side(0.0, interval.lowest), side(0.0, interval.highest),
                            side(interval.length, interval.lowest),
                            side(interval.length, interval.highest)};
  const double slack = tolerance::zeroDistance * d.norm();
  const auto [lowest, highest] = std::minmax_element(std::begin(corners), std::end(corners));
  if (*lowest > slack || *highest < -slack) {
    return;
  }
  const double coefficients[] = {-offset, interval.c() * d.x() - d.y(), interval.b * d.x(),
                                 interval.a * d.x()};
  for (const double t : rootsWithin(coefficients, 0.0, interval.length)) {
    const Vec2 place(t, interval.offset(t));
    choice.consider((place - w).dot(d) / d.squaredNorm());
  }
}
}  // namespace

std::optional<double> directedDistance(const TabulatedCylinder& surface,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  const Vec2 d = surface.projected(direction);
  if (d.cwiseAbs().sum() <= tolerance::nullDirection) {
    return std::nullopt;
  }
  CrossingChoice choice(which);
  for (const TabulatedCylinder::Interval& interval : surface.intervals) {
    considerInterval(interval, surface.projected(from), d, choice);
  }
  return choice.result();
}

std::optional<double> directedDistance(const Torus& torus,
                                       const Vec3& from,
                                       const Vec3& direction,
                                       Crossing which) {
  // With q = p - C: (q.q + R^2 - r^2)^2 = 4 R^2 (q.q - (q.T)^2), a quartic in s, from the foot of
  // the center so that the terms stay of the size of the torus.
  const double dd = direction.squaredNorm();
  const double shift = (torus.center - from).dot(direction) / dd;
  const Vec3 w = from + shift * direction - torus.center;
  const double wt = w.dot(torus.axis);
  const double dt = direction.dot(torus.axis);
  const double r2 = torus.major * torus.major;
  const double m =
      w.squaredNorm() + r2 - torus.minor * torus.minor;  // q.q + R^2 - r^2 = dd s^2 + m
  const double coefficients[] = {m * m - 4.0 * r2 * (w.squaredNorm() - wt * wt), 8.0 * r2 * wt * dt,
                                 2.0 * m * dd - 4.0 * r2 * (dd - dt * dt), 0.0, dd * dd};
  const double reach = (torus.major + torus.minor) * 1.001 / std::sqrt(dd);
  CrossingChoice choice(which);
  for (const double s : rootsWithin(coefficients, -reach, reach)) {
    choice.consider(s + shift);
  }
  return choice.result();
}

}  // namespace arelem::geometry
