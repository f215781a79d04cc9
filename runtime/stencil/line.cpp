#include "runtime/stencil/line.h"

#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::stencil {

namespace {
constexpr double radian = std::numbers::pi / 180.0;

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Area of the part of a cell between two shares of its lines; negative where it folds over.
double areaBetween(const Line& from, const Line& to, double low, double high) {
  const Vec2 along = from.second - from.first;
  const Vec2 next = to.second - to.first;
  const std::array<Vec2, 4> corner = {from.first + low * along, from.first + high * along,
                                      to.first + high * next, to.first + low * next};
  return 0.5 * (cross(corner[1] - corner[0], corner[2] - corner[0]) +
                cross(corner[2] - corner[0], corner[3] - corner[0]));
}
}  // namespace

Vec2 middleOf(const Line& line) {
  return 0.5 * (line.first + line.second);
}

double widthOf(const Line& line) {
  return (line.second - line.first).norm();
}

double yawOf(const Line& line) {
  const Vec2 d = line.second - line.first;
  return std::atan2(d.y(), d.x()) / radian;
}

double heightFor(double width, double fan) {
  return 0.5 * width / std::tan(0.5 * fan * radian);
}

double areaShare(const Line& from, const Line& to) {
  return areaShare(from, to, 0.5);
}

double areaShare(const Line& from, const Line& to, double s) {
  const double first = std::abs(areaBetween(from, to, 0.0, s));
  const double second = std::abs(areaBetween(from, to, s, 1.0));
  return first + second > 0.0 ? 100.0 * first / (first + second) : 50.0;
}

double trapezoidShare(double b1, double b2) {
  return 0.5 * (b1 + b2) / (b1 + std::sqrt(0.5 * (b1 * b1 + b2 * b2)));
}

double quadrilateralShare(const Line& from, const Line& to) {
  // The first half's area rises with the share, from nothing to all of the cell.
  double low = 0.0;
  double high = 1.0;
  const double all = areaBetween(from, to, 0.0, 1.0);
  const double sign = all < 0.0 ? -1.0 : 1.0;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double s = 0.5 * (low + high);
    (sign * areaBetween(from, to, 0.0, s) < 0.5 * sign * all ? low : high) = s;
  }
  return 0.5 * (low + high);
}

double tiltFor(double share, double fan) {
  return std::atan((2.0 * share - 1.0) / std::tan(0.5 * fan * radian)) / radian;
}

double shareOf(double tilt, double fan) {
  return 0.5 * (1.0 + std::tan(tilt * radian) * std::tan(0.5 * fan * radian));
}

Tilted placeTilted(double width, double fan, double tilt) {
  const double whole = std::sin(fan * radian);
  const double half = 0.5 * fan;
  return {0.5 * width * std::sin(2.0 * tilt * radian) / whole,
          width * std::cos((half + tilt) * radian) * std::cos((half - tilt) * radian) / whole};
}

}  // namespace arelem::stencil
