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
  const double ll = a.low * b.low;
  const double lh = a.low * b.high;
  const double hl = a.high * b.low;
  const double hh = a.high * b.high;
  return {std::min(std::min(ll, lh), std::min(hl, hh)),
          std::max(std::max(ll, lh), std::max(hl, hh))};
}
inline Interval operator*(double a, const Interval& b) {
  const double low = a * b.low;
  const double high = a * b.high;
  return {std::min(low, high), std::max(low, high)};
}
/// `b` must not hold 0.
inline Interval operator/(const Interval& a, const Interval& b) {
  return a * Interval(1.0 / b.high, 1.0 / b.low);
}

}  // namespace arelem::geometry
