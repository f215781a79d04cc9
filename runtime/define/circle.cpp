// CIRCLE definitions: vertical cylinders; z of given places is ignored.
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/exact.h"

namespace arelem::define {

using geometry::Circle;
using geometry::Line;
using geometry::Vec2;

namespace {
Result<Resolved> circleAt(const Vec2& center, double radius) {
  Result<double> positive = positiveRadius(radius);
  if (!positive) {
    return positive.takeFailure();
  }
  return Resolved(Circle{{center.x(), center.y(), 0.0}, *positive});
}

Result<Resolved> circleAt(Result<Vec2> center, double radius) {
  if (!center) {
    return center.takeFailure();
  }
  return circleAt(*center, radius);
}

/// Radius of the circle of centers that touch `circle` from inside (IN) or outside.
double centersRadius(Word side, const Circle& circle, double radius) {
  return side == Word::IN ? std::abs(circle.radius - radius) : circle.radius + radius;
}
}  // namespace

Result<Resolved> circleOfFourNumbers(const Arguments& given) {
  return circleAt(given.pair(0), given.scalar(3));
}

Result<Resolved> circleOfThreeNumbers(const Arguments& given) {
  return circleAt(given.pair(0), given.scalar(2));
}

Result<Resolved> circleOfCenter(const Arguments& given) {
  return circleAt(given.pointInXy(1), given.scalar(3));
}

Result<Resolved> circleOfCenterCoordinates(const Arguments& given) {
  return circleAt(given.pair(1), given.scalar(5));
}

Result<Resolved> circleTangentToLine(const Arguments& given) {
  const Vec2 center = given.pointInXy(1);
  return circleAt(center, std::abs(given.line(3).height(center)));
}

Result<Resolved> circleThroughPoint(const Arguments& given) {
  return circleAt(given.pointInXy(1), (given.pointInXy(2) - given.pointInXy(1)).norm());
}

Result<Resolved> circleOfPoints(const Arguments& given) {
  const Vec2 origin = given.pointInXy(0);
  const Vec2 b = given.pointInXy(1) - origin;
  const Vec2 c = given.pointInXy(2) - origin;
  const double area = b.x() * c.y() - b.y() * c.x();
  const double longest = std::max({b.norm(), c.norm(), (c - b).norm()});
  if (std::abs(area) <= tolerance::singular * longest * longest) {
    return fail(diag::Collinear, "the three points",
                longest > 0.0 ? std::abs(area) / longest : 0.0);
  }
  const Vec2 center(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                    b.x() * c.squaredNorm() - c.x() * b.squaredNorm());
  const Vec2 step = center / (2.0 * area);
  return circleAt(origin + step, step.norm());
}

Result<Resolved> circleTangentToCircle(const Arguments& given) {
  const Circle circle = given.circle(4);
  const Vec2 center = given.pointInXy(1);
  const double distance = (circle.middle() - center).norm();
  return circleAt(center, given.is(2, Word::LARGE) ? circle.radius + distance
                                                   : std::abs(circle.radius - distance));
}

Result<Resolved> circleTangentToLines(const Arguments& given) {
  const double radius = given.scalar(5);
  Result<Line> first = offset(given.line(1), given.word(0), radius);
  if (!first) {
    return first.takeFailure();
  }
  Result<Line> second = offset(given.line(3), given.word(2), radius);
  if (!second) {
    return second.takeFailure();
  }
  return circleAt(meet(*first, *second), radius);
}

Result<Resolved> circleTangentThroughPoint(const Arguments& given) {
  const Line line = given.line(1);
  const Vec2 place = given.pointInXy(3);
  const double radius = given.scalar(5);
  Line centers = line;
  if (std::abs(line.height(place)) <= tolerance::coincidence) {
    // The circle touches the line at the point itself; the modifier says on which side.
    Result<Line> moved = offset(line, given.word(2), radius);
    if (!moved) {
      return moved.takeFailure();
    }
    return circleAt(Vec2(place + radius * moved->normal), radius);
  }
  const int side =
      geometry::sideOfLine(line.normal.x(), line.normal.y(), line.distance, place.x(), place.y());
  centers.distance += side * radius;
  Result<Candidates> candidates = meet(centers, place, radius);
  if (!candidates) {
    return candidates.takeFailure().note(
        fmt::format("the point is {:.9g} from the line, at most twice the radius is possible",
                    std::abs(line.height(place))));
  }
  return circleAt(choose(given.word(2), *candidates), radius);
}

Result<Resolved> circleTangentToLineAndCircle(const Arguments& given) {
  const double radius = given.scalar(6);
  const Circle circle = given.circle(4);
  Result<Line> centers = offset(given.line(1), given.word(0), radius);
  if (!centers) {
    return centers.takeFailure();
  }
  Result<Candidates> candidates =
      meet(*centers, circle.middle(), centersRadius(given.word(3), circle, radius));
  if (!candidates) {
    return candidates.takeFailure().note(fmt::format(
        "centers at {:.9g} from the line on the {} side", radius, spell(given.word(0))));
  }
  return circleAt(choose(given.word(2), *candidates), radius);
}

Result<Resolved> circleTangentToCircles(const Arguments& given) {
  const double radius = given.scalar(6);
  const Circle first = given.circle(2);
  const Circle second = given.circle(4);
  Result<Candidates> candidates =
      meet(first.middle(), centersRadius(given.word(1), first, radius), second.middle(),
           centersRadius(given.word(3), second, radius));
  if (!candidates) {
    return candidates.takeFailure().note("measured for the circles on which the center must lie");
  }
  return circleAt(choose(given.word(0), *candidates), radius);
}

}  // namespace arelem::define
