// PLANE definitions.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"

namespace arelem::define {

using geometry::Plane;

namespace {
Plane through(const Vec3& place, const Vec3& normal) {
  return {normal, normal.dot(place)};
}

/// Through `place` with the direction of `normal`, whose null case is named by `what`.
Result<Resolved> planeThrough(const Vec3& place, const Vec3& normal, std::string_view what) {
  Result<Vec3> direction = unit(normal, what);
  if (!direction) {
    return direction.takeFailure();
  }
  return Resolved(through(place, *direction));
}

Result<Resolved> normalToPlane(const Plane& plane, const Vec3& first, const Vec3& second) {
  return planeThrough(
      first, plane.normal.cross(first - second),
      "the plane (its points are one above the other, seen along the normal of the given plane)");
}
}  // namespace

Result<Resolved> planeOfCoefficients(const Arguments& given) {
  const Vec3 normal = given.triple(0);
  const double length = normal.norm();
  if (!(length > 0.0)) {
    return fail(diag::NullDirection, "the plane", 0.0, tolerance::nullDirection);
  }
  return Resolved(Plane{normal / length, given.scalar(3) / length});
}

Result<Resolved> planeOfPoints(const Arguments& given) {
  const Vec3 first = given.point(0);
  const Vec3 side = given.point(1) - first;
  const Vec3 normal = side.cross(given.point(2) - first);
  if (!(normal.cwiseAbs().maxCoeff() > tolerance::nullDirection)) {
    const double off = side.norm() > 0.0 ? normal.norm() / side.norm() : 0.0;
    return fail(diag::Collinear, "the three points", off);
  }
  return Resolved(through(first, normal.normalized()));
}

Result<Resolved> planeParallelThroughPoint(const Arguments& given) {
  return Resolved(through(given.point(0), given.plane(2).normal));
}

Result<Resolved> planeOffset(const Arguments& given) {
  const Plane plane = given.plane(1);
  Result<Vec3> normal = orient(given.word(2), plane.normal);
  if (!normal) {
    return normal.takeFailure();
  }
  const double distance = normal->dot(plane.normal) < 0.0 ? -plane.distance : plane.distance;
  return Resolved(Plane{*normal, distance + given.scalar(3)});
}

Result<Resolved> planeNormalToVector(const Arguments& given) {
  return planeThrough(given.point(0), given.arrow(2), "the vector");
}

Result<Resolved> planeNormalToPlaneFirst(const Arguments& given) {
  return normalToPlane(given.plane(1), given.point(2), given.point(3));
}

Result<Resolved> planeNormalToPlaneLast(const Arguments& given) {
  return normalToPlane(given.plane(3), given.point(0), given.point(1));
}

Result<Resolved> planeNormalToPlanes(const Arguments& given) {
  const Vec3 normal = given.plane(2).normal.cross(given.plane(3).normal);
  if (normal.norm() <= tolerance::singular) {
    return fail(diag::Parallel, "the planes", normal.norm(), "line");
  }
  return Resolved(through(given.point(0), normal.normalized()));
}

}  // namespace arelem::define
