#include "runtime/define/tabcyl_place.h"

#include <cmath>
#include <limits>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/polynomial.h"

namespace arelem::define {

using geometry::TabulatedCylinder;
using geometry::Vec2;
using Interval = TabulatedCylinder::Interval;

namespace {
/// A place in the chord frame of an interval.
Vec2 localOf(const Interval& interval, const Vec2& place) {
  const Vec2 w = place - interval.start;
  return {w.dot(interval.along), w.dot(interval.across())};
}
}  // namespace

Result<CurveInXy> CurveInXy::of(const Entity& tabcyl) {
  TabulatedCylinder surface = TabulatedCylinder::of(tabcyl.canon);
  const double lean = surface.generatrix().head<2>().norm();
  if (lean > tolerance::perpendicular) {
    return fail(diag::NotVertical, spell(tabcyl.type), lean);
  }
  // Express the curve in x, y: a generatrix along -z makes (u, v) a mirrored frame, then offsets
  // change sign.
  Eigen::Matrix2d toXy;
  toXy << surface.frame(0, 0), surface.frame(1, 0), surface.frame(0, 1), surface.frame(1, 1);
  const double sign = toXy.determinant() < 0.0 ? -1.0 : 1.0;
  for (Interval& interval : surface.intervals) {
    interval.start = toXy * interval.start;
    interval.along = toXy * interval.along;
    interval.a *= sign;
    interval.b *= sign;
    interval.bound();
  }
  surface.end = toXy * surface.end;
  surface.frame.setIdentity();
  return CurveInXy(std::move(surface));
}

CurvePlace CurveInXy::place(std::size_t interval, double t) const {
  return {interval, t, surface_.intervals[interval].at(t)};
}

std::vector<CurvePlace> CurveInXy::onLine(const geometry::Line& line) const {
  std::vector<CurvePlace> places;
  for (std::size_t i = 0; i < intervals().size(); ++i) {
    const Interval& interval = intervals()[i];
    const double m = line.normal.dot(interval.along);
    const double n = line.normal.dot(interval.across());
    // height(start) + m t + n v(t) = 0
    const double coefficients[] = {line.height(interval.start), m + n * interval.c(),
                                   n * interval.b, n * interval.a};
    for (const double t : geometry::rootsWithin(coefficients, 0.0, interval.length)) {
      places.push_back(place(i, t));
    }
  }
  return places;
}

std::vector<CurvePlace> CurveInXy::tangentThrough(const Vec2& from) const {
  std::vector<CurvePlace> places;
  for (std::size_t i = 0; i < intervals().size(); ++i) {
    const Interval& interval = intervals()[i];
    const double a = interval.a, b = interval.b, c = interval.c();
    const Vec2 p = localOf(interval, from);
    // (t - x) v' - (v - y) = 2a t^3 + (b - 3a x) t^2 - 2b x t + y - c x
    const double coefficients[] = {p.y() - c * p.x(), -2.0 * b * p.x(), b - 3.0 * a * p.x(),
                                   2.0 * a};
    if (interval.extension) {
      continue;  // a straight interval is its own tangent; its ends belong to the neighbors
    }
    for (const double t : geometry::rootsWithin(coefficients, 0.0, interval.length)) {
      places.push_back(place(i, t));
    }
  }
  return places;
}

std::vector<CurvePlace> CurveInXy::normalThrough(const Vec2& from) const {
  std::vector<CurvePlace> places;
  for (std::size_t i = 0; i < intervals().size(); ++i) {
    const Interval& interval = intervals()[i];
    const double a = interval.a, b = interval.b, c = interval.c();
    const Vec2 p = localOf(interval, from);
    // (t - x) + (v - y) v'
    const double coefficients[] = {-p.x() - p.y() * c,
                                   1.0 + c * c - 2.0 * b * p.y(),
                                   3.0 * b * c - 3.0 * a * p.y(),
                                   2.0 * b * b + 4.0 * a * c,
                                   5.0 * a * b,
                                   3.0 * a * a};
    for (const double t : geometry::rootsWithin(coefficients, 0.0, interval.length)) {
      places.push_back(place(i, t));
    }
  }
  return places;
}

std::optional<CurvePlace> CurveInXy::select(const std::vector<CurvePlace>& places,
                                            const Vec2& nearPoint) const {
  std::size_t named = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < intervals().size(); ++i) {
    const double distance = (intervals()[i].start - nearPoint).norm();
    if (distance < nearest) {
      nearest = distance;
      named = i;
    }
  }
  const auto rank = [&](const CurvePlace& p) {
    return p.interval > named ? p.interval - named : named - p.interval;
  };
  std::optional<CurvePlace> best;
  for (const CurvePlace& p : places) {
    if (!best || rank(p) < rank(*best) ||
        (rank(p) == rank(*best) &&
         (p.at.place - nearPoint).norm() < (best->at.place - nearPoint).norm())) {
      best = p;
    }
  }
  return best;
}

}  // namespace arelem::define
