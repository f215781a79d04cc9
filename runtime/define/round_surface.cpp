// CYLNDR, CONE, SPHERE and TORUS definitions.
#include <cmath>

#include <Eigen/LU>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Cone;
using geometry::Cylinder;
using geometry::Sphere;
using geometry::Torus;

namespace {
Result<Resolved> cylinderOf(const Vec3& point, const Vec3& direction, double radius) {
  Result<Vec3> axis = unit(direction, "the axis");
  if (!axis) {
    return axis.takeFailure();
  }
  Result<double> positive = positiveRadius(radius);
  if (!positive) {
    return positive.takeFailure();
  }
  return Resolved(Cylinder{point, *axis, *positive});
}

Result<Resolved> sphereOf(const Vec3& center, double radius) {
  Result<double> positive = positiveRadius(radius);
  if (!positive) {
    return positive.takeFailure();
  }
  return Resolved(Sphere{center, *positive});
}

Result<Resolved> torusOf(const Vec3& center, const Vec3& direction, double major, double minor) {
  Result<Vec3> axis = unit(direction, "the axis");
  if (!axis) {
    return axis.takeFailure();
  }
  for (const double radius : {major, minor}) {
    Result<double> positive = positiveRadius(radius);
    if (!positive) {
      return positive.takeFailure();
    }
  }
  return Resolved(Torus{center, *axis, major, minor});
}
}  // namespace

Result<Resolved> cylinderOfSevenNumbers(const Arguments& given) {
  return cylinderOf(given.triple(0), given.triple(3), given.scalar(6));
}

Result<Resolved> cylinderOfPoint(const Arguments& given) {
  return cylinderOf(given.point(0), given.triple(1), given.scalar(4));
}

Result<Resolved> cylinderOfVector(const Arguments& given) {
  return cylinderOf(given.triple(0), given.arrow(3), given.scalar(4));
}

Result<Resolved> cylinderOfPointAndVector(const Arguments& given) {
  return cylinderOf(given.point(0), given.arrow(1), given.scalar(2));
}

Result<Resolved> coneOfPointAndVector(const Arguments& given) {
  Result<Vec3> axis = unit(given.arrow(1), "the axis");
  if (!axis) {
    return axis.takeFailure();
  }
  const double half = given.scalar(2);
  if (!(half > 0.0 && half < 90.0)) {
    return fail(diag::BadRange, "the half angle", half, "between 0 and 90 degrees, ends excluded");
  }
  return Resolved(Cone{given.point(0), *axis, geometry::sinCosDegrees(half).cos});
}

Result<Resolved> sphereOfNumbers(const Arguments& given) {
  return sphereOf(given.triple(0), given.scalar(3));
}

Result<Resolved> sphereOfPoint(const Arguments& given) {
  return sphereOf(given.point(0), given.scalar(1));
}

Result<Resolved> sphereOfCenter(const Arguments& given) {
  return sphereOf(given.point(1), given.scalar(3));
}

Result<Resolved> sphereThroughPoint(const Arguments& given) {
  return sphereOf(given.point(1), (given.point(2) - given.point(1)).norm());
}

Result<Resolved> sphereTangentToPlane(const Arguments& given) {
  return sphereOf(given.point(1), std::abs(given.plane(3).height(given.point(1))));
}

Result<Resolved> sphereOfPoints(const Arguments& given) {
  const Vec3 origin = given.point(0);
  Eigen::Matrix3d sides;
  Vec3 squares;
  double longest = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Vec3 side = given.point(static_cast<std::size_t>(i) + 1) - origin;
    sides.row(i) = side.transpose();
    squares(i) = side.squaredNorm();
    longest = std::max(longest, side.norm());
  }
  const double volume = sides.determinant();
  if (std::abs(volume) <= tolerance::singular * longest * longest * longest) {
    const Vec3 normal = Vec3(sides.row(0)).cross(Vec3(sides.row(1)));
    const double off = normal.norm() > 0.0 ? std::abs(volume) / normal.norm() : 0.0;
    return fail(diag::Coplanar, "the four points", off);
  }
  const Vec3 center = 0.5 * sides.fullPivLu().solve(squares);
  return sphereOf(origin + center, center.norm());
}

Result<Resolved> torusOfNumbers(const Arguments& given) {
  return torusOf(given.triple(0), given.triple(3), given.scalar(6), given.scalar(7));
}

Result<Resolved> torusOfPointAndVector(const Arguments& given) {
  return torusOf(given.point(0), given.arrow(1), given.scalar(2), given.scalar(3));
}

}  // namespace arelem::define
