// VECTOR definitions. A point counts as the vector from the origin to it.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/choice.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Direction;
using geometry::SinCos;

namespace {
/// The language's unit vector: components of at most 1e-6 become 0.
Result<Resolved> cleanUnit(const Vec3& vector) {
  Result<Vec3> direction = unit(vector, "the vector");
  if (!direction) {
    return direction.takeFailure();
  }
  return Resolved(Direction{direction->unaryExpr(
      [](double v) { return std::abs(v) <= tolerance::nullDirection ? 0.0 : v; })});
}

Result<Resolved> oriented(Word modifier, const Vec3& direction, double uncertainty = 0.0) {
  Result<Vec3> result = orient(modifier, direction, uncertainty);
  if (!result) {
    return result.takeFailure();
  }
  return Resolved(Direction{*result});
}
}  // namespace

Result<Resolved> vectorOfComponents(const Arguments& given) {
  return Resolved(Direction{given.triple(0)});
}

Result<Resolved> vectorOfSixCoordinates(const Arguments& given) {
  return Resolved(Direction{given.triple(3) - given.triple(0)});
}

Result<Resolved> vectorOfPoints(const Arguments& given) {
  return Resolved(Direction{given.point(1) - given.point(0)});
}

Result<Resolved> vectorNormalToPlane(const Arguments& given) {
  return oriented(given.word(2), given.plane(1).normal);
}

Result<Resolved> vectorTimes(const Arguments& given) {
  return Resolved(Direction{given.scalar(0) * given.arrow(2)});
}

Result<Resolved> vectorCross(const Arguments& given) {
  return Resolved(Direction{given.arrow(0).cross(given.arrow(2))});
}

Result<Resolved> vectorUnit(const Arguments& given) {
  return cleanUnit(given.arrow(1));
}

Result<Resolved> vectorUnitOfComponents(const Arguments& given) {
  return cleanUnit(given.triple(1));
}

Result<Resolved> vectorAtAngle(const Arguments& given) {
  const SinCos angle = geometry::sinCosDegrees(given.scalar(3));
  const double first = given.scalar(1) * angle.cos;
  const double second = given.scalar(1) * angle.sin;
  if (given.is(4, Word::XYPLAN)) {
    return Resolved(Direction{{first, second, 0.0}});
  }
  return given.is(4, Word::YZPLAN) ? Resolved(Direction{{0.0, first, second}})
                                   : Resolved(Direction{{second, 0.0, first}});
}

Result<Resolved> vectorAlongPlanes(const Arguments& given) {
  const Vec3 along = given.plane(2).normal.cross(given.plane(3).normal);
  if (along.norm() <= tolerance::singular) {
    return fail(diag::Parallel, "the planes", along.norm(), "line");
  }
  return oriented(given.word(4), along.normalized(), tolerance::rounding / along.norm());
}

Result<Resolved> vectorSum(const Arguments& given) {
  return Resolved(Direction{given.arrow(0) + given.arrow(2)});
}

Result<Resolved> vectorDifference(const Arguments& given) {
  return Resolved(Direction{given.arrow(0) - given.arrow(2)});
}

Result<Resolved> vectorAtAngleToLine(const Arguments& given) {
  const geometry::Vec2 n = given.line(2).normal;
  const SinCos angle = geometry::sinCosDegrees(given.scalar(1));
  return oriented(given.word(3), {n.x() * angle.sin + n.y() * angle.cos,
                                  n.y() * angle.sin - n.x() * angle.cos, 0.0});
}

}  // namespace arelem::define
