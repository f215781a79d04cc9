#include "runtime/motion/chord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::motion {

namespace {
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Cubics err: what a chord dips is taken for this share more.
constexpr double cubicError = 1e-3;
/// Crossings of tangents nearer than this share to an end tell nothing new.
constexpr double nearEnd = 0.05;
/// Trials of a chord over even change of curvature, and the square of the factor by which it may be
/// too short.
constexpr int swayTrials = 8;
constexpr double swayFit = 1.01;

/// g(x) = gap + first x + second x^2 + third x^3 over x in [0, 1].
struct Cubic {
  double gap, first, second, third;

  Cubic(const GapNode& a, const GapNode& b) : gap(a.gap) {
    const double length = b.along - a.along;
    const double end = b.slope * length;
    const double change = b.gap - a.gap;
    first = a.slope * length;
    second = 3.0 * change - 2.0 * first - end;
    third = first + end - 2.0 * change;
  }
  [[nodiscard]] double at(double x) const { return gap + x * (first + x * (second + x * third)); }
  [[nodiscard]] double slopeAt(double x) const {
    return first + x * (2.0 * second + 3.0 * x * third);
  }
  /// True where the slope keeps its sign: the three that it is a mean of everywhere have one.
  [[nodiscard]] bool keepsSlope() const {
    const double end = first + 2.0 * second + 3.0 * third;
    const double between = first + second;
    return (first >= 0.0 && between >= 0.0 && end >= 0.0) ||
           (first <= 0.0 && between <= 0.0 && end <= 0.0);
  }
};

struct Extremes {
  double least, greatest;
  double leastAt, greatestAt;  ///< shares of the part
};

Extremes extremes(const Cubic& c) {
  Extremes e{c.gap, c.gap, 0.0, 0.0};
  const auto consider = [&](double x) {
    const double g = c.at(x);
    if (g < e.least) {
      e.least = g;
      e.leastAt = x;
    }
    if (g > e.greatest) {
      e.greatest = g;
      e.greatestAt = x;
    }
  };
  consider(1.0);
  if (c.keepsSlope()) {
    return e;
  }
  const double disc = c.second * c.second - 3.0 * c.third * c.first;
  if (disc >= 0.0) {
    const double q = -(c.second + std::copysign(std::sqrt(disc), c.second));
    for (const double x :
         {c.third != 0.0 ? q / (3.0 * c.third) : -1.0, q != 0.0 ? c.first / q : -1.0}) {
      if (x > 0.0 && x < 1.0) {
        consider(x);
      }
    }
  }
  return e;
}
}  // namespace

double meanCurvature(double before, double behind, double length) {
  const double change = behind - before;
  return std::abs(change) <= levelChange ? 0.0 : change / length;
}

double longestChord(double bend, double from, double to, double inner, double outer) {
  if (bend == 0.0) {
    return unlimited;
  }
  // The parabola over a chord touches the band's edge where the two square roots meet.
  const double a = bend > 0.0 ? from + inner : outer - from;
  const double b = bend > 0.0 ? to + inner : outer - to;
  return (std::sqrt(std::max(a, 0.0)) + std::sqrt(std::max(b, 0.0))) *
         std::sqrt(2.0 / std::abs(bend));
}

double longestSway(
    double bend, double trend, double from, double to, double inner, double outer, double guess) {
  double length = guess;
  double longest = 0.0;
  for (int i = 0; i < swayTrials; ++i) {
    // What is left of the line between the ends where the second derivative is -(bend + trend x).
    const double rise = (to - from) / length;
    const GapNode a{0.0, from, rise - length * (0.5 * bend + trend * length / 6.0)};
    const GapNode b{length, to, rise + length * (0.5 * bend + trend * length / 3.0)};
    const double squared = squaredFit(GapLine(a, b), a, b, inner, outer);
    longest = squared >= 1.0 ? std::max(longest, length) : longest;
    if (squared >= 1.0 && squared <= swayFit) {
      break;
    }
    // The dip grows with the square of the length by the curvature, with the cube by its trend.
    length *= std::clamp(std::pow(squared, 0.4), 0.3, 3.0);
  }
  return longest;
}

bool foretold(const GapNode& a, const GapNode& b, const GapNode& between, double tolerance) {
  const double length = b.along - a.along;
  const Cubic c(a, b);
  const double x = (between.along - a.along) / length;
  return std::abs(c.at(x) - between.gap) <= tolerance &&
         std::abs(c.slopeAt(x) - between.slope * length) <= 8.0 * tolerance;
}

double crossing(const GapNode& a, const GapNode& b) {
  const double length = b.along - a.along;
  const double bend = a.slope - b.slope;
  const double at = bend > 0.0 ? (b.gap - a.gap - b.slope * length) / bend : -1.0;
  const bool inside = at > nearEnd * length && at < (1.0 - nearEnd) * length;
  return a.along + (inside ? at : 0.5 * length);
}

double squaredFit(
    const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer) {
  // Ends lie on the line between them; rounding must not make a dip of that.
  const double rounding = 1e-9 * (inner + outer);
  const Extremes e = extremes(Cubic(a, b));
  const auto line = [&](double x) { return ends.at(a.along + x * (b.along - a.along)); };
  double factor = unlimited;
  const double lowLine = line(e.leastAt);
  const double dip = (1.0 + cubicError) * (lowLine - e.least);
  if (dip > rounding) {
    factor = std::max(0.0, lowLine + inner) / dip;
  }
  const double highLine = line(e.greatestAt);
  const double rise = (1.0 + cubicError) * (e.greatest - highLine);
  if (rise > rounding) {
    factor = std::min(factor, std::max(0.0, outer - highLine) / rise);
  }
  return factor;
}

double swerve(const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer) {
  const Extremes e = extremes(Cubic(a, b));
  const auto line = [&](double x) { return ends.at(a.along + x * (b.along - a.along)); };
  return -inner - e.least >= e.greatest - outer ? line(e.leastAt) - e.least
                                                : line(e.greatestAt) - e.greatest;
}

}  // namespace arelem::motion
