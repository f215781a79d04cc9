// LINE definitions: vertical planes. The sign of a normal follows the method, as the reference
// says.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Line;
using geometry::SinCos;
using geometry::Vec2;

namespace {
Result<Resolved> resolved(Result<Line> line) {
  if (!line) {
    return line.takeFailure();
  }
  return Resolved(*line);
}

SinCos inclination(Word how, double value) {
  return how == Word::ATANGL ? geometry::sinCosDegrees(value) : geometry::sinCosOfTangent(value);
}

/// Through a place at an angle to the x axis, counterclockwise.
Result<Resolved> fromX(const Vec2& place, const SinCos& angle) {
  return Resolved(lineAlong(place, angle.cos, angle.sin));
}

/// The direction is +y turned counterclockwise; its right-hand normal is (cos, sin).
Result<Resolved> fromY(const Vec2& place, const SinCos& angle) {
  return Resolved(lineWithNormal(place, {angle.cos, angle.sin}));
}

Result<Resolved> turnedFrom(const Line& line, const Vec2& place, const SinCos& angle) {
  const Vec2& n = line.normal;
  return Resolved(lineWithNormal(
      place, {n.x() * angle.cos - n.y() * angle.sin, n.x() * angle.sin + n.y() * angle.cos}));
}

struct TangentCircle {
  Word side = Word::LEFT;
  Vec2 center = Vec2::Zero();
  double radius = 0.0;
};

/// Common tangent; sides seen from the first circle to the second. The normal points from the line
/// to the second center: n.C2 - D = R2 and n.C1 - D = R1 (equal sides) or -R1.
Result<Line> commonTangent(const TangentCircle& first, const TangentCircle& second) {
  const Vec2 step = second.center - first.center;
  const double length = step.norm();
  if (length <= tolerance::coincidence) {
    return fail(diag::Coincident, "the centers", length);
  }
  const bool outer = first.side == second.side || first.radius == 0.0;
  const double rise = outer ? second.radius - first.radius : second.radius + first.radius;
  if (std::abs(rise) > length + tolerance::coincidence) {
    return fail(diag::NoTangent,
                outer ? "one circle (or the point) is inside the other" : "the circles overlap",
                length, std::abs(rise));
  }
  const double cosine = std::clamp(rise / length, -1.0, 1.0);
  const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
  const Vec2 u = step / length;
  const Vec2 across = second.side == Word::LEFT ? Vec2(u.y(), -u.x()) : Vec2(-u.y(), u.x());
  const Vec2 normal = (cosine * u + sine * across).normalized();
  return Line{normal, normal.dot(second.center) - second.radius};
}
}  // namespace

Result<Resolved> lineOfSixCoordinates(const Arguments& given) {
  return resolved(lineThrough(given.pair(0), given.pair(3)));
}

Result<Resolved> lineOfFourCoordinates(const Arguments& given) {
  return resolved(lineThrough(given.pair(0), given.pair(2)));
}

Result<Resolved> lineOfPoints(const Arguments& given) {
  return resolved(lineThrough(given.pointInXy(0), given.pointInXy(1)));
}

Result<Resolved> lineOfPointAndTangent(const Arguments& given) {
  const geometry::Circle circle = given.circle(3);
  return resolved(commonTangent({given.word(1), given.pointInXy(0), 0.0},
                                {given.word(1), circle.middle(), circle.radius}));
}

Result<Resolved> lineOfTwoTangents(const Arguments& given) {
  const geometry::Circle first = given.circle(2);
  const geometry::Circle second = given.circle(5);
  return resolved(commonTangent({given.word(0), first.middle(), first.radius},
                                {given.word(3), second.middle(), second.radius}));
}

Result<Resolved> lineAtAngleToX(const Arguments& given) {
  return fromX(given.pointInXy(0), geometry::sinCosDegrees(given.scalar(2)));
}

Result<Resolved> lineAtAngleToY(const Arguments& given) {
  return fromY(given.pointInXy(0), geometry::sinCosDegrees(given.scalar(2)));
}

Result<Resolved> lineOfSlope(const Arguments& given) {
  const SinCos angle = geometry::sinCosOfTangent(given.scalar(2));
  return given.is(3, Word::YAXIS) ? fromY(given.pointInXy(0), angle)
                                  : fromX(given.pointInXy(0), angle);
}

Result<Resolved> lineOfAxis(const Arguments& given) {
  return Resolved(given.is(0, Word::XAXIS) ? Line{{0.0, 1.0}, 0.0} : Line{{1.0, 0.0}, 0.0});
}

Result<Resolved> lineOfSlopeToLine(const Arguments& given) {
  return turnedFrom(given.line(3), given.pointInXy(0), geometry::sinCosOfTangent(given.scalar(2)));
}

Result<Resolved> lineAtAngleToLine(const Arguments& given) {
  return turnedFrom(given.line(3), given.pointInXy(0), geometry::sinCosDegrees(given.scalar(2)));
}

Result<Resolved> lineParallelThroughPoint(const Arguments& given) {
  return Resolved(lineWithNormal(given.pointInXy(0), given.line(2).normal));
}

Result<Resolved> linePerpendicularThroughPoint(const Arguments& given) {
  return Resolved(lineWithNormal(given.pointInXy(0), given.line(2).along()));
}

Result<Resolved> lineOffset(const Arguments& given) {
  return resolved(offset(given.line(1), given.word(2), given.scalar(3)));
}

Result<Resolved> lineOfPlanes(const Arguments& given) {
  const geometry::Plane m = given.plane(1);
  const geometry::Plane n = given.plane(2);
  const Vec2 normal = n.normal.z() * m.normal.head<2>() - m.normal.z() * n.normal.head<2>();
  const double length = normal.norm();
  if (length <= tolerance::singular) {
    return fail(diag::Parallel, "the planes, or both are vertical: they", length,
                "line with a direction in xy");
  }
  const double distance = m.distance * n.normal.z() - n.distance * m.normal.z();
  return Resolved(Line{normal / length, distance / length});
}

Result<Resolved> lineOfYIntercept(const Arguments& given) {
  const double intercept = given.scalar(given.count() - 1);
  return fromX({0.0, intercept}, inclination(given.word(0), given.scalar(1)));
}

Result<Resolved> lineOfXIntercept(const Arguments& given) {
  return fromX({given.scalar(4), 0.0}, inclination(given.word(0), given.scalar(1)));
}

}  // namespace arelem::define
