#include "runtime/motion/chord.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::motion {

namespace {
constexpr double unlimited = std::numeric_limits<double>::infinity();

struct Extremes {
  double least, greatest;
  double leastAt, greatestAt;  ///< share of the chord
};

Extremes extremes(const ChordProfile& c) {
  // g(x) = p0 + m0 x + b x^2 + a x^3 over x in [0, 1].
  const double m0 = c.slopeFrom * c.length;
  const double m1 = c.slopeTo * c.length;
  const double d = c.gapTo - c.gapFrom;
  const double a = m0 + m1 - 2.0 * d;
  const double b = 3.0 * d - 2.0 * m0 - m1;
  const auto value = [&](double x) { return c.gapFrom + x * (m0 + x * (b + x * a)); };
  Extremes e{c.gapFrom, c.gapFrom, 0.0, 0.0};
  const auto consider = [&](double x) {
    const double g = value(x);
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
  const double disc = b * b - 3.0 * a * m0;
  if (disc >= 0.0) {
    const double q = -(b + std::copysign(std::sqrt(disc), b));
    for (const double x : {a != 0.0 ? q / (3.0 * a) : -1.0, q != 0.0 ? m0 / q : -1.0}) {
      if (x > 0.0 && x < 1.0) {
        consider(x);
      }
    }
  }
  return e;
}
}  // namespace

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

double fittingFactor(const ChordProfile& first,
                     const ChordProfile& second,
                     double inner,
                     double outer) {
  const double whole = first.length + second.length;
  const auto line = [&](double s) {
    return first.gapFrom + s / whole * (second.gapTo - first.gapFrom);
  };
  // Ends lie on the line between them; rounding must not make a dip of that.
  const double rounding = 1e-9 * (inner + outer);
  double factor = unlimited;
  double start = 0.0;
  for (const ChordProfile* half : {&first, &second}) {
    const Extremes e = extremes(*half);
    const double lowLine = line(start + e.leastAt * half->length);
    const double highLine = line(start + e.greatestAt * half->length);
    if (lowLine - e.least > rounding) {
      factor = std::min(factor, std::max(0.0, lowLine + inner) / (lowLine - e.least));
    }
    if (e.greatest - highLine > rounding) {
      factor = std::min(factor, std::max(0.0, outer - highLine) / (e.greatest - highLine));
    }
    start += half->length;
  }
  return std::sqrt(factor);
}

}  // namespace arelem::motion
