#pragma once
#include <cmath>

namespace arelem::diag {

/// A factor that would do, as four digits of a message tell it: never more than it is. Positive.
[[nodiscard]] inline double toldFactor(double factor) {
  constexpr double rounding = 1e-9;
  constexpr double digits = 4.0;
  const double digit = std::pow(10.0, std::floor(std::log10(factor)) + 1.0 - digits);
  return std::floor(factor / digit * (1.0 + rounding)) * digit;
}

}  // namespace arelem::diag
