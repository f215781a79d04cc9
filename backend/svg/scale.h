#pragma once
#include <string>

namespace arelem::backend::svg {

/// A span of values and the step of its ticks: 1, 2 or 5 times a power of ten.
struct Scale {
  double low = 0.0;
  double high = 1.0;
  double step = 1.0;
  int decimals = 0;  ///< that the ticks need

  /// About `ticks` of them. A span of nothing is widened to 1.
  Scale(double least, double most, double ticks);
  /// Begins and ends at ticks.
  void wide();
  [[nodiscard]] double firstTick() const;
  /// The number at a tick; steps that add up to nearly 0 are 0.
  [[nodiscard]] std::string text(double value) const;
};

}  // namespace arelem::backend::svg
