// PATERN definitions: lists of points. Grids run to and fro: every second column is reversed.
#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/resolve.h"
#include "runtime/geometry/angle.h"

namespace arelem::define {

using geometry::Canon;
using Kind = PatternShape::Kind;

namespace {

/// Bounds memory; the old system had 330.
constexpr std::size_t mostPoints = 1'000'000;

using Points = std::vector<Vec3>;

Result<Resolved> patternOf(const Points& points, PatternShape shape) {
  Canon canon;
  canon.reserve(3 * points.size());
  for (const Vec3& p : points) {
    canon.insert(canon.end(), {p.x(), p.y(), p.z()});
  }
  return Resolved(std::move(canon), shape);
}

Points pointsOf(const Entity& pattern) {
  Points points;
  for (std::size_t i = 0; i + 2 < pattern.canon.size(); i += 3) {
    points.emplace_back(pattern.canon[i], pattern.canon[i + 1], pattern.canon[i + 2]);
  }
  return points;
}

/// A number of points or columns.
Result<std::size_t> countOf(double value, double least) {
  const double whole = std::round(value);
  if (std::abs(value - whole) > tolerance::wholeNumber || whole < least) {
    return fail(diag::BadRange, "the number of points or columns", value,
                least > 1.0 ? "a whole number from 2" : "a whole number from 1");
  }
  if (whole > static_cast<double>(mostPoints)) {
    return fail(diag::PatternTooLarge, whole, mostPoints);
  }
  return static_cast<std::size_t>(whole);
}

/// The successive increments from parameter `first`, which is INCR: d1, d2, ... or groups n, AT, d.
Result<std::vector<double>> readSteps(const Arguments& given, std::size_t first) {
  std::vector<double> steps;
  std::size_t i = first;
  while (i < given.count()) {
    if (given.is(i, Word::INCR)) {
      ++i;
      continue;
    }
    if (!given.is(i + 1, Word::AT)) {
      steps.push_back(given.scalar(i++));
      continue;
    }
    Result<std::size_t> count = countOf(given.scalar(i), 1.0);
    if (!count) {
      return count.takeFailure();
    }
    if (steps.size() + *count > mostPoints) {
      return fail(diag::PatternTooLarge, static_cast<double>(steps.size() + *count), mostPoints);
    }
    steps.insert(steps.end(), *count, given.scalar(i + 2));
    i += 3;
  }
  return steps;
}

/// 0, d1, d1 + d2, ...
std::vector<double> partialSums(const std::vector<double>& steps) {
  std::vector<double> sums{0.0};
  for (const double step : steps) {
    sums.push_back(sums.back() + step);
  }
  return sums;
}

Result<Vec3> unitAlong(const Vec3& vector) {
  const double largest = vector.cwiseAbs().maxCoeff();
  if (!(largest > tolerance::nullDirection)) {
    return fail(diag::NullDirection, "the vector", largest, tolerance::nullDirection);
  }
  return Vec3(vector.normalized());
}

std::string_view describeKind(Kind kind) {
  switch (kind) {
    case Kind::linear:
      return "a linear";
    case Kind::arc:
      return "an arc";
    case Kind::random:
      return "a random";
    case Kind::parallel:
      break;
  }
  return "a parallel";
}

Result<Points> linearPoints(const Arguments& given, std::size_t i) {
  const Entity& pattern = given.entity(i);
  if (pattern.pattern.kind != Kind::linear) {
    return fail(diag::PatternNotLinear, i + 1, describeKind(pattern.pattern.kind));
  }
  return pointsOf(pattern);
}

/// Copies of the column at the shifts, every second one reversed.
Result<Resolved> grid(const Points& column, const Points& shifts) {
  const double total = static_cast<double>(column.size()) * static_cast<double>(shifts.size());
  if (total > static_cast<double>(mostPoints)) {
    return fail(diag::PatternTooLarge, total, mostPoints);
  }
  Points points;
  for (std::size_t k = 0; k < shifts.size(); ++k) {
    for (std::size_t i = 0; i < column.size(); ++i) {
      points.push_back(column[k % 2 == 0 ? i : column.size() - 1 - i] + shifts[k]);
    }
  }
  return patternOf(points, {Kind::parallel, static_cast<int>(shifts.size())});
}

Result<Resolved> arc(const Arguments& given, const std::vector<double>& degrees) {
  const geometry::Circle circle = given.circle(1);
  Points points;
  for (const double angle : degrees) {
    const geometry::SinCos at = geometry::sinCosDegrees(angle);
    points.push_back(
        given.onZsurf(circle.middle() + circle.radius * geometry::Vec2(at.cos, at.sin)));
  }
  return patternOf(points, {Kind::arc, 1});
}

}  // namespace

Result<Resolved> patternBetweenPoints(const Arguments& given) {
  Result<std::size_t> count = countOf(given.scalar(3), 2.0);
  if (!count) {
    return count.takeFailure();
  }
  const Vec3 step = (given.point(2) - given.point(1)) / static_cast<double>(*count - 1);
  Points points;
  for (std::size_t i = 0; i < *count; ++i) {
    points.emplace_back(given.point(1) + static_cast<double>(i) * step);
  }
  points.back() = given.point(2);
  return patternOf(points, {Kind::linear, 1});
}

Result<Resolved> patternAlongVector(const Arguments& given) {
  Result<std::size_t> count = countOf(given.scalar(3), 1.0);
  if (!count) {
    return count.takeFailure();
  }
  Points points;
  for (std::size_t i = 0; i < *count; ++i) {
    points.emplace_back(given.point(1) + static_cast<double>(i) * given.arrow(2));
  }
  return patternOf(points, {Kind::linear, 1});
}

/// From the first place to each: the partial sums of the steps behind parameter 3, along the vector
/// at 2.
Result<Points> shiftsOfSteps(const Arguments& given) {
  Result<std::vector<double>> steps = readSteps(given, 3);
  if (!steps) {
    return steps.takeFailure();
  }
  Result<Vec3> along = unitAlong(given.arrow(2));
  if (!along) {
    return along.takeFailure();
  }
  Points shifts;
  for (const double distance : partialSums(*steps)) {
    shifts.emplace_back(distance * *along);
  }
  return shifts;
}

Result<Resolved> patternOfSteps(const Arguments& given) {
  Result<Points> points = shiftsOfSteps(given);
  if (!points) {
    return points.takeFailure();
  }
  for (Vec3& place : *points) {
    place = given.point(1) + place;
  }
  return patternOf(*points, {Kind::linear, 1});
}

Result<Resolved> patternOnArc(const Arguments& given) {
  Result<std::size_t> count = countOf(given.scalar(5), 2.0);
  if (!count) {
    return count.takeFailure();
  }
  const double start = given.scalar(2);
  const double sign = given.is(4, Word::CLW) ? -1.0 : 1.0;
  double total = given.scalar(3) - start;
  if (sign * total <= 0.0) {
    total = sign * (360.0 - std::fmod(-sign * total, 360.0));
  }
  std::vector<double> degrees;
  for (std::size_t i = 0; i < *count; ++i) {
    degrees.push_back(start + total * static_cast<double>(i) / static_cast<double>(*count - 1));
  }
  return arc(given, degrees);
}

Result<Resolved> patternOfAngles(const Arguments& given) {
  Result<std::vector<double>> steps = readSteps(given, 4);
  if (!steps) {
    return steps.takeFailure();
  }
  const double sign = given.is(3, Word::CLW) ? -1.0 : 1.0;
  std::vector<double> degrees = partialSums(*steps);
  for (double& angle : degrees) {
    angle = given.scalar(2) + sign * angle;
  }
  return arc(given, degrees);
}

Result<Resolved> gridOfPatterns(const Arguments& given) {
  Result<Points> column = linearPoints(given, 1);
  if (!column) {
    return column.takeFailure();
  }
  Result<Points> other = linearPoints(given, 2);
  if (!other) {
    return other.takeFailure();
  }
  const auto gap = [&](const Vec3& end) {
    return std::min((end - column->front()).norm(), (end - column->back()).norm());
  };
  if (gap(other->back()) < gap(other->front())) {
    std::reverse(other->begin(), other->end());
  }
  if (gap(other->front()) > tolerance::coincidence) {
    return fail(diag::PatternsApart, gap(other->front()));
  }
  const Vec3 shared = other->front();
  for (Vec3& place : *other) {
    place -= shared;
  }
  return grid(*column, *other);
}

Result<Resolved> gridAlongVector(const Arguments& given) {
  Result<Points> column = linearPoints(given, 1);
  if (!column) {
    return column.takeFailure();
  }
  Result<std::size_t> count = countOf(given.scalar(3), 1.0);
  if (!count) {
    return count.takeFailure();
  }
  Points shifts;
  for (std::size_t i = 0; i < *count; ++i) {
    shifts.emplace_back(static_cast<double>(i) * given.arrow(2));
  }
  return grid(*column, shifts);
}

Result<Resolved> gridOfSteps(const Arguments& given) {
  Result<Points> column = linearPoints(given, 1);
  if (!column) {
    return column.takeFailure();
  }
  Result<Points> shifts = shiftsOfSteps(given);
  if (!shifts) {
    return shifts.takeFailure();
  }
  return grid(*column, *shifts);
}

Result<Resolved> patternOfList(const Arguments& given) {
  Points points;
  for (std::size_t i = 1; i < given.count(); ++i) {
    const Points more =
        given.is(i, EntityType::point) ? Points{given.point(i)} : pointsOf(given.entity(i));
    if (points.size() + more.size() > mostPoints) {
      return fail(diag::PatternTooLarge, static_cast<double>(points.size() + more.size()),
                  mostPoints);
    }
    points.insert(points.end(), more.begin(), more.end());
  }
  return patternOf(points, {Kind::random, 1});
}

}  // namespace arelem::define
