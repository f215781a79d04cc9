#include "runtime/motion/chord.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/gap_cubic.h"

namespace arelem::motion {

namespace {
/// Trials of a chord over even change of curvature, and the square of the factor by which it may be
/// too short.
constexpr int swayTrials = 8;
constexpr double swayFit = 1.01;
}  // namespace

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

}  // namespace arelem::motion
