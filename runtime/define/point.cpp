// POINT definitions.
#include <cmath>

#include <Eigen/LU>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/planar.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"
#include "runtime/geometry/roots.h"

namespace arelem::define {

using geometry::Line;
using geometry::Plane;
using geometry::Point;
using geometry::SinCos;
using geometry::Vec2;

namespace {
/// A place found in the xy plane, lifted to ZSURF.
Result<Resolved> lifted(const Arguments& given, Result<Vec2> place) {
  if (!place) {
    return place.takeFailure();
  }
  return Resolved(Point{given.onZsurf(*place)});
}

Result<Resolved> chosen(const Arguments& given, Result<Candidates> candidates) {
  if (!candidates) {
    return candidates.takeFailure();
  }
  return lifted(given, choose(given.word(0), *candidates));
}
}  // namespace

Result<Resolved> pointOfCoordinates(const Arguments& given) {
  return Resolved(Point{given.triple(0)});
}

Result<Resolved> pointOnZsurf(const Arguments& given) {
  return Resolved(Point{given.onZsurf(given.pair(0))});
}

Result<Resolved> pointOfLines(const Arguments& given) {
  return lifted(given, meet(given.line(1), given.line(2)));
}

Result<Resolved> pointOfLineAndCircle(const Arguments& given) {
  const geometry::Circle circle = given.circle(3);
  return chosen(given, meet(given.line(2), circle.middle(), circle.radius));
}

Result<Resolved> pointOfCircles(const Arguments& given) {
  const geometry::Circle first = given.circle(2);
  const geometry::Circle second = given.circle(3);
  return chosen(given, meet(first.middle(), first.radius, second.middle(), second.radius));
}

Result<Resolved> pointOnCircle(const Arguments& given) {
  const geometry::Circle circle = given.circle(0);
  const SinCos angle = geometry::sinCosDegrees(given.scalar(2));
  return lifted(given, Vec2(circle.middle() + circle.radius * Vec2(angle.cos, angle.sin)));
}

Result<Resolved> pointAtCenter(const Arguments& given) {
  return lifted(given, given.circle(1).middle());
}

namespace {
/// The line p0 + t u in the conic's z = 0 section: a t^2 + 2 b t + c = 0.
Result<Candidates> meetConic(const Line& line, const geometry::Quadric& conic) {
  const Vec2 origin = line.distance * line.normal;
  const Eigen::Vector4d p(origin.x(), origin.y(), 0.0, 1.0);
  const Eigen::Vector4d u(line.along().x(), line.along().y(), 0.0, 0.0);
  const double a = u.dot(conic.matrix * u);
  const double b = u.dot(conic.matrix * p);
  const double c = p.dot(conic.matrix * p);
  const auto place = [&](double t) { return Vec2(origin + t * line.along()); };
  const geometry::QuadraticRoots roots = geometry::solveQuadratic(a, b, c);
  if (roots.count == 2) {
    return Candidates{place(roots.first), place(roots.second), false};
  }
  if (roots.count == 1) {
    return Candidates{place(roots.first), place(roots.first), true};
  }
  if (a == 0.0) {
    return fail(diag::Parallel, "line and asymptote or axis of the conic", 0.0, "point");
  }
  // Nearest approach: at t = -b/a the gradient is along the normal of the line.
  const Vec3 near(place(-b / a).x(), place(-b / a).y(), 0.0);
  const double gap = std::abs(conic.value(near)) / conic.gradient(near).norm();
  if (gap <= tolerance::coincidence) {
    return Candidates{near.head<2>(), near.head<2>(), true};
  }
  return fail(diag::NoIntersection, "line and conic", gap, tolerance::coincidence)
      .note("they are nearest at about " + show(Vec2(near.head<2>())));
}
}  // namespace

Result<Resolved> pointOfLineAndConic(const Arguments& given) {
  return chosen(given, meetConic(given.line(2), given.quadric(3)));
}

Result<Resolved> pointOfPlanes(const Arguments& given) {
  Eigen::Matrix3d normals;
  Vec3 distances;
  for (int i = 0; i < 3; ++i) {
    const Plane plane = given.plane(static_cast<std::size_t>(i) + 1);
    normals.row(i) = plane.normal.transpose();
    distances(i) = plane.distance;
  }
  const double determinant = normals.determinant();
  if (std::abs(determinant) <= tolerance::singular) {
    return fail(diag::Parallel, "two of the planes, or the common lines of two,", determinant,
                "point");
  }
  return Resolved(Point{normals.fullPivLu().solve(distances)});
}

Result<Resolved> pointOfPolarCoordinates(const Arguments& given) {
  const bool radiusFirst = given.is(0, Word::RTHETA);
  const double radius = given.scalar(radiusFirst ? 2 : 3);
  const SinCos angle = geometry::sinCosDegrees(given.scalar(radiusFirst ? 3 : 2));
  const double first = radius * angle.cos;
  const double second = radius * angle.sin;
  if (given.is(1, Word::XYPLAN)) {
    return Resolved(Point{{first, second, 0.0}});
  }
  return given.is(1, Word::YZPLAN) ? Resolved(Point{{0.0, first, second}})
                                   : Resolved(Point{{second, 0.0, first}});
}

Result<Resolved> pointOfPattern(const Arguments& given) {
  const std::vector<double>& canon = given.entity(0).canon;
  const std::size_t count = canon.size() / 3;
  const double index = std::round(given.scalar(1));
  if (std::abs(given.scalar(1) - index) > tolerance::wholeNumber || index < 1.0 ||
      index > static_cast<double>(count)) {
    return fail(diag::PatternIndex, given.scalar(1), count);
  }
  const std::size_t first = 3 * (static_cast<std::size_t>(index) - 1);
  return Resolved(Point{{canon[first], canon[first + 1], canon[first + 2]}});
}

}  // namespace arelem::define
