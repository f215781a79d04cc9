#pragma once
#include <cmath>
#include <limits>

/// Private to runtime/tool.
namespace arelem::tool {

/// A zero of a slope lies between the places where the slope was last negative and positive.
struct Bracket {
  /// Iterations after which it is halved whatever Newton says.
  static constexpr int patience = 12;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  void note(double at, double slope) { (slope < 0.0 ? low : high) = at; }
  [[nodiscard]] bool closed() const { return std::isfinite(high - low); }
  /// The place proposed, or the middle where that leaves the bracket or takes too long.
  [[nodiscard]] double keep(double proposed, int iteration) const {
    const bool outside = proposed <= low || proposed >= high;
    return closed() && (outside || iteration > patience) ? 0.5 * (low + high) : proposed;
  }
};

}  // namespace arelem::tool
