#include "runtime/spray/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/spray.h"

namespace arelem::spray {

namespace {
using Point = std::pair<double, double>;

/// Of a table: far finer than any film gauge measures.
constexpr std::size_t mostPoints = 20000;

double trapezoid(const Point& a, const Point& b) {
  return (b.first - a.first) * (a.second + b.second) / 2.0;
}

double area(std::span<const Point> points) {
  double sum = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    sum += trapezoid(points[i - 1], points[i]);
  }
  return sum;
}

/// What keeps a table from being a profile.
std::optional<Failure> objection(std::span<const Point> points) {
  if (points.size() < 2) {
    return fail(diag::ProfileTable, fmt::format("{} points", points.size()), "at least 2");
  }
  if (points.size() > mostPoints) {
    return fail(diag::ProfileTable, fmt::format("{} points", points.size()), "at most 20000");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].second < 0.0) {
      return fail(diag::ProfileTable,
                  fmt::format("the film {} at {}", points[i].second, points[i].first),
                  "films that are not negative");
    }
    if (i > 0 && points[i].first <= points[i - 1].first) {
      return fail(diag::ProfileTable,
                  fmt::format("the place {} after {}", points[i].first, points[i - 1].first),
                  "rising places");
    }
  }
  if (!(area(points) > 0.0)) {
    return fail(diag::ProfileTable, "no film at all", "a film above 0");
  }
  return std::nullopt;
}
}  // namespace

Profile Profile::ellipse() {
  return Profile(Kind::ellipse);
}

Profile Profile::flat() {
  return Profile(Kind::flat);
}

Result<Profile::Measured> Profile::table(std::span<const Point> points) {
  if (std::optional<Failure> failure = objection(points)) {
    return *std::move(failure);
  }
  const double center = (points.front().first + points.back().first) / 2.0;
  const double half = (points.back().first - points.front().first) / 2.0;
  std::vector<Point> scaled;
  for (const Point& p : points) {
    scaled.emplace_back((p.first - center) / half, p.second);
  }
  return Measured{normalized(std::move(scaled)), half};
}

Profile Profile::normalized(std::vector<Point> points) {
  Profile profile(Kind::table);
  const double whole = area(points);
  profile.knots_.clear();
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].second /= whole;
    sum += i == 0 ? 0.0 : trapezoid(points[i - 1], points[i]);
    profile.knots_.push_back(points[i].first);
    profile.shares_.push_back(sum);
  }
  profile.points_ = std::move(points);
  return profile;
}

double Profile::density(double u) const {
  if (!(std::abs(u) <= 1.0)) {
    return 0.0;
  }
  switch (kind_) {
    case Kind::ellipse:
      return 2.0 / std::numbers::pi * std::sqrt(1.0 - u * u);
    case Kind::flat:
      return 0.5;
    case Kind::table:
      break;
  }
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), u);
  if (above == knots_.end()) {
    return points_.back().second;
  }
  const auto i = static_cast<std::size_t>(above - knots_.begin());
  if (i == 0) {
    return points_.front().second;
  }
  const double t = (u - knots_[i - 1]) / (knots_[i] - knots_[i - 1]);
  return points_[i - 1].second + t * (points_[i].second - points_[i - 1].second);
}

double Profile::share(double u) const {
  if (u <= -1.0) {
    return 0.0;
  }
  if (u >= 1.0) {
    return 1.0;
  }
  switch (kind_) {
    case Kind::ellipse:
      return 0.5 + (u * std::sqrt(1.0 - u * u) + std::asin(u)) / std::numbers::pi;
    case Kind::flat:
      return (1.0 + u) / 2.0;
    case Kind::table:
      break;
  }
  const auto above = std::upper_bound(knots_.begin(), knots_.end(), u);
  const auto i = static_cast<std::size_t>(above - knots_.begin());
  return i == 0 ? 0.0 : shares_[i - 1] + trapezoid(points_[i - 1], {u, density(u)});
}

}  // namespace arelem::spray
