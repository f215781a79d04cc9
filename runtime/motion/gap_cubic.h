#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

/// The gap along a chord between places where it and its slope are known: a cubic. Inline: every
/// cut vector takes some.
namespace arelem::motion {

/// What is known of a gap at one place of a chord.
struct GapNode {
  double along = 0.0;  ///< length of the chord up to here
  double gap = 0.0;
  double slope = 0.0;  ///< of the gap, per length
};

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

[[nodiscard]] inline Extremes extremes(const Cubic& c) {
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

/// True where the cubic through `a` and `b` foretells `between`, a node between them, but for
/// `tolerance`: the gap is smooth there, and cubics through all three err by a sixteenth of that.
[[nodiscard]] inline bool foretold(const GapNode& a,
                                   const GapNode& b,
                                   const GapNode& between,
                                   double tolerance) {
  const double length = b.along - a.along;
  const Cubic c(a, b);
  const double x = (between.along - a.along) / length;
  return std::abs(c.at(x) - between.gap) <= tolerance &&
         std::abs(c.slopeAt(x) - between.slope * length) <= 8.0 * tolerance;
}

/// Where the tangents at two nodes cross, or the middle: there a gap whose contact jumps from one
/// place of the cutter to another has its ridge.
[[nodiscard]] inline double crossing(const GapNode& a, const GapNode& b) {
  constexpr double nearEnd = 0.05;  // what is nearer to an end than this share tells nothing new
  const double length = b.along - a.along;
  const double bend = a.slope - b.slope;
  const double at = bend > 0.0 ? (b.gap - a.gap - b.slope * length) / bend : -1.0;
  const bool inside = at > nearEnd * length && at < (1.0 - nearEnd) * length;
  return a.along + (inside ? at : 0.5 * length);
}

/// The straight line from the gap at one end of a chord to that at the other.
struct GapLine {
  double along = 0.0;  ///< where it starts
  double gap = 0.0;
  double steepness = 0.0;

  GapLine() = default;
  GapLine(const GapNode& first, const GapNode& last)
      : along(first.along),
        gap(first.gap),
        steepness((last.gap - first.gap) / (last.along - first.along)) {}
  [[nodiscard]] double at(double place) const { return gap + steepness * (place - along); }
};

/// Square of the factor by which to scale the length of a chord with these ends so that its part
/// between `a` and `b` just fits the band; above 1 where there is room.
[[nodiscard]] inline double squaredFit(
    const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer) {
  constexpr double cubicError = 1e-3;  // what a chord dips is taken for this share more
  // Ends lie on the line between them; rounding must not make a dip of that.
  const double rounding = 1e-9 * (inner + outer);
  const Extremes e = extremes(Cubic(a, b));
  const auto line = [&](double x) { return ends.at(a.along + x * (b.along - a.along)); };
  double factor = std::numeric_limits<double>::infinity();
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

/// How far that part of a chord leaves the line between its ends where it is most outside the band:
/// positive where the gap is below the line.
[[nodiscard]] inline double swerve(
    const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer) {
  const Extremes e = extremes(Cubic(a, b));
  const auto line = [&](double x) { return ends.at(a.along + x * (b.along - a.along)); };
  return -inner - e.least >= e.greatest - outer ? line(e.leastAt) - e.least
                                                : line(e.greatestAt) - e.greatest;
}

}  // namespace arelem::motion
