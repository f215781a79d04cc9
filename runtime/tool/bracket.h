#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

/// Private to runtime/tool.
namespace arelem::tool {

/// A zero of a slope lies between the places where the slope was last negative and positive.
struct Bracket {
  /// Iterations after which it is halved whatever Newton says.
  static constexpr int patience = 12;
  /// Steps before they grow, and how often they double.
  static constexpr int free = 3, mostDoublings = 20;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  /// Steps by less than the curvature tells go on for ever where that is small: those to the same
  /// side grow.
  int onwards = 0;  ///< positive: steps that went on to that side, else to the other
  [[nodiscard]] double paced(double step) {
    onwards = step > 0.0 ? std::max(onwards, 0) + 1 : std::min(onwards, 0) - 1;
    return std::ldexp(step, std::clamp(std::abs(onwards) - free, 0, mostDoublings));
  }

  void note(double at, double slope) { (slope < 0.0 ? low : high) = at; }
  [[nodiscard]] bool closed() const { return std::isfinite(high - low); }
  /// The place proposed, or the middle where that leaves the bracket or takes too long.
  [[nodiscard]] double keep(double proposed, int iteration) const {
    const bool outside = proposed <= low || proposed >= high;
    return closed() && (outside || iteration > patience) ? 0.5 * (low + high) : proposed;
  }
};

}  // namespace arelem::tool
