#include "runtime/define/planar.h"

#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"

namespace arelem::define {

using geometry::Line;
using geometry::Vec2;

Result<Line> lineThrough(const Vec2& first, const Vec2& second) {
  const Vec2 step = second - first;
  Result<Vec3> normal = unit({step.y(), -step.x(), 0.0}, "the line");
  if (!normal) {
    return normal.takeFailure().note("the points are at " + show(first) + " and " + show(second));
  }
  return lineWithNormal(first, normal->head<2>());
}

Line lineAlong(const Vec2& place, double cosine, double sine) {
  return lineWithNormal(place, {-sine, cosine});
}

Line lineWithNormal(const Vec2& place, const Vec2& normal) {
  return {normal, normal.dot(place)};
}

Result<Line> offset(const Line& line, Word modifier, double distance) {
  const Vec3 given(line.normal.x(), line.normal.y(), 0.0);
  Result<Vec3> normal = orient(modifier, given);
  if (!normal) {
    return normal.takeFailure();
  }
  const bool reversed = normal->dot(given) < 0.0;
  return Line{normal->head<2>(), (reversed ? -line.distance : line.distance) + distance};
}

Result<Vec2> meet(const Line& first, const Line& second) {
  const Vec2& m = first.normal;
  const Vec2& n = second.normal;
  const double sine = m.x() * n.y() - m.y() * n.x();
  if (std::abs(sine) <= tolerance::singular) {
    return fail(diag::Parallel, "the lines", sine, "point")
        .note(
            fmt::format("they are {:.9g} apart",
                        std::abs(second.distance - std::copysign(1.0, m.dot(n)) * first.distance)));
  }
  return Vec2((first.distance * n.y() - second.distance * m.y()) / sine,
              (m.x() * second.distance - n.x() * first.distance) / sine);
}

Result<Candidates> meet(const Line& line, const Vec2& center, double radius) {
  const double towards = -line.height(center);
  const Vec2 foot = center + towards * line.normal;
  if (std::abs(std::abs(towards) - radius) <= tolerance::coincidence) {
    return Candidates{foot, foot, true};
  }
  if (std::abs(towards) > radius) {
    return fail(diag::NoIntersection, "line and circle", std::abs(towards), radius)
        .note("the foot of the center on the line is at " + show(foot));
  }
  const double half = std::sqrt((radius - towards) * (radius + towards));
  return Candidates{foot - half * line.along(), foot + half * line.along(), false};
}

Result<Candidates> meet(const Vec2& center1, double radius1, const Vec2& center2, double radius2) {
  const Vec2 step = center2 - center1;
  const double length = step.norm();
  if (length <= tolerance::coincidence) {
    return fail(diag::Coincident, "the centers of the circles", length);
  }
  const double sum = radius1 + radius2;
  const double difference = std::abs(radius1 - radius2);
  const Vec2 u = step / length;
  const bool tangent = std::abs(length - sum) <= tolerance::coincidence ||
                       std::abs(length - difference) <= tolerance::coincidence;
  if (!tangent && length > sum) {
    return fail(diag::NoIntersection, "the circles", length, sum);
  }
  if (!tangent && length < difference) {
    return fail(diag::NoIntersection, "the circles", length, difference)
        .note("one circle lies inside the other");
  }
  const double d = ((radius1 - radius2) * (radius1 + radius2) + length * length) / (2.0 * length);
  const Vec2 foot = center1 + d * u;
  if (tangent) {
    return Candidates{foot, foot, true};
  }
  const double half = std::sqrt((radius1 - d) * (radius1 + d));
  const Vec2 across(-u.y(), u.x());
  return Candidates{foot - half * across, foot + half * across, false};
}

Result<double> positiveRadius(double radius) {
  if (!(radius > 0.0)) {
    return fail(diag::BadRadius, radius);
  }
  return radius;
}

}  // namespace arelem::define
