#pragma once
#include <algorithm>
#include <cmath>

namespace arelem::geometry {

/// All numbers from low to high. Results of its arithmetic hold every result of numbers of the
/// operands, but for rounding.
struct Interval {
  double low = 0.0, high = 0.0;

  constexpr Interval() = default;
  constexpr Interval(double value) : low(value), high(value) {}  // NOLINT: numbers are intervals
  constexpr Interval(double from, double to) : low(from), high(to) {}

  [[nodiscard]] double middle() const { return 0.5 * (low + high); }
  [[nodiscard]] double half() const { return 0.5 * (high - low); }
  [[nodiscard]] double size() const { return std::max(std::abs(low), std::abs(high)); }
  [[nodiscard]] bool holdsZero() const { return low <= 0.0 && high >= 0.0; }
};

[[nodiscard]] inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

inline Interval operator+(const Interval& a, const Interval& b) {
  return {a.low + b.low, a.high + b.high};
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return {a.low - b.high, a.high - b.low};
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}
/// `b` must not hold 0.
inline Interval operator/(const Interval& a, const Interval& b) {
  return a * Interval(1.0 / b.high, 1.0 / b.low);
}

}  // namespace arelem::geometry
