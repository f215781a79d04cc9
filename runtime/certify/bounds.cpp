#include "runtime/certify/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace arelem::certify {

namespace {
/// Least value over u in [0, 1] of the chord from `a` to `b` less the sag k u (1 - u) / 2.
double lowestOfChord(double a, double b, double k) {
  double least = std::min(a, b);
  if (k > 0.0) {
    const double u = 0.5 - (b - a) / k;
    if (u > 0.0 && u < 1.0) {
      least = std::min(least, a + (b - a) * u - 0.5 * k * u * (1.0 - u));
    }
  }
  return least;
}

/// Least value over u in [0, 1] of the greater of the two parabolas a + p u - k u^2 / 2 and
/// b - q (1 - u) - k (1 - u)^2 / 2, k >= 0. Their difference is a line, and each is lowest at an
/// end of the part where it is the greater one.
double lowestOfTangents(double a, double p, double b, double q, double k) {
  const auto first = [&](double u) { return a + p * u - 0.5 * k * u * u; };
  const auto second = [&](double u) {
    const double v = 1.0 - u;
    return b - q * v - 0.5 * k * v * v;
  };
  const auto greater = [&](double u) { return std::max(first(u), second(u)); };
  double least = std::min(greater(0.0), greater(1.0));
  const double d0 = first(0.0) - second(0.0);
  const double d1 = first(1.0) - second(1.0);
  if ((d0 > 0.0) != (d1 > 0.0)) {
    least = std::min(least, greater(d0 / (d0 - d1)));
  }
  return least;
}

/// Lower bound; the upper one is that of the function turned upside down.
double lowest(const Known& a, const Known& b, double h, const Curving& curving, double rate) {
  // Along both slopes of the greatest rate.
  double best = 0.5 * (a.low + b.low - rate * h);
  if (std::isfinite(curving.most)) {
    best = std::max(best, lowestOfChord(a.low, b.low, std::max(0.0, curving.most) * h * h));
  }
  if (std::isfinite(curving.least)) {
    best = std::max(best, lowestOfTangents(a.low, a.slope * h, b.low, b.slope * h,
                                           std::max(0.0, -curving.least) * h * h));
  }
  return best;
}
}  // namespace

Range between(const Known& a, const Known& b, double h, const Curving& curving, double rate) {
  const Known c{-a.high, -a.low, -a.slope};
  const Known d{-b.high, -b.low, -b.slope};
  return {lowest(a, b, h, curving, rate), -lowest(c, d, h, {-curving.most, -curving.least}, rate)};
}

}  // namespace arelem::certify
