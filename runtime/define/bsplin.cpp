// BSPLIN definitions: path splines, and points of them.
#include <algorithm>
#include <optional>

#include "ir/diag/curves.h"
#include "ir/diag/spline.h"
#include "ir/space/tolerance.h"
#include "runtime/define/resolve.h"
#include "runtime/spline/fit.h"

namespace arelem::define {

namespace {

using spline::CubicSpline;

/// Points, or coordinates by threes, from parameter `next` on to the end or to KNOTS.
std::vector<Vec3> readPoints(const Arguments& given, std::size_t& next) {
  std::vector<Vec3> points;
  while (next < given.count() && !given.is(next, Word::KNOTS)) {
    const bool isPoint = given.isEntity(next);
    points.push_back(isPoint ? given.point(next) : given.triple(next));
    next += isPoint ? 1 : 3;
  }
  return points;
}

/// Successive control points in one place would stop the curve there.
std::optional<Failure> coincidence(const std::vector<Vec3>& points, bool closed) {
  for (std::size_t i = closed && points.size() > 1 ? 0 : 1; i < points.size(); ++i) {
    const std::size_t before = (i + points.size() - 1) % points.size();
    const double apart = (points[i] - points[before]).norm();
    if (!(apart > tolerance::sameSide)) {
      return fail(diag::SplinePointsCoincide, before + 1, i + 1, apart);
    }
  }
  return std::nullopt;
}

Result<Resolved> resolved(Result<CubicSpline> curve) {
  if (!curve) {
    return curve.takeFailure();
  }
  if (const auto t = spline::cuspOf(*curve)) {
    const Vec3 p = curve->at(*t);
    return fail(diag::SplineCusp, *t, p.x(), p.y(), p.z());
  }
  return Resolved(curve->canon());
}

Result<Resolved> resolved(const Vec3& place) {
  return Resolved(geometry::Point{place});
}

}  // namespace

Result<Resolved> splineOfControlPoints(const Arguments& given) {
  const bool closed = given.is(0, Word::CLOSED);
  std::size_t next = closed ? 1 : 0;
  std::vector<Vec3> points = readPoints(given, next);
  if (auto failure = coincidence(points, closed)) {
    return *std::move(failure);
  }
  if (closed && !points.empty()) {
    // The first knot belongs to the second control point; a program means its first one.
    std::rotate(points.begin(), points.end() - 1, points.end());
  }
  if (next == given.count()) {
    return resolved(CubicSpline::uniform(std::move(points), closed));
  }
  std::vector<double> knots;
  for (++next; next < given.count(); ++next) {
    knots.push_back(given.scalar(next));
  }
  return resolved(CubicSpline::make(std::move(points), std::move(knots), closed));
}

Result<Resolved> splineThroughPoints(const Arguments& given) {
  const bool closed = given.is(1, Word::CLOSED);
  std::size_t next = closed ? 2 : 1;
  return resolved(spline::interpolate(readPoints(given, next), closed));
}

Result<Resolved> splineNearPoints(const Arguments& given) {
  const bool closed = given.is(1, Word::CLOSED);
  std::size_t next = closed ? 3 : 2;
  const double tolerance = given.scalar(next++);
  if (!(tolerance > 0.0)) {
    return fail(diag::SplineTolerance, tolerance);
  }
  return resolved(spline::approximate(readPoints(given, next), tolerance, closed));
}

Result<Resolved> splineWithKnots(const Arguments& given) {
  Result<CubicSpline> curve = CubicSpline::of(given.entity(0).canon);
  for (std::size_t i = 2; curve && i < given.count(); ++i) {
    curve = curve->withKnot(given.scalar(i));
  }
  return resolved(std::move(curve));
}

Result<Resolved> pointOfSpline(const Arguments& given) {
  const Result<CubicSpline> curve = CubicSpline::of(given.entity(0).canon);
  if (!curve) {
    return curve.failure();
  }
  const double t = given.scalar(1);
  if (!curve->closed() && !(t >= curve->begin() && t <= curve->end())) {
    return fail(diag::SplineParameter, t, curve->begin(), curve->end());
  }
  return resolved(curve->at(t));
}

Result<Resolved> pointNextToSpline(const Arguments& given) {
  const Result<CubicSpline> curve = CubicSpline::of(given.entity(0).canon);
  if (!curve) {
    return curve.failure();
  }
  return resolved(curve->nearest(given.point(1)).point);
}

}  // namespace arelem::define
