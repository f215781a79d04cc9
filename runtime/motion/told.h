#pragma once
#include <algorithm>
#include <cmath>

#include "ir/space/vector.h"

namespace arelem::motion {

/// A place as messages tell it: coordinates that are rounding, or the last step of a search, beside
/// the others or 1 are zero.
[[nodiscard]] inline Vec3 told(const Vec3& place) {
  constexpr double rounding = 1e-6;
  const double size = rounding * std::max(1.0, place.cwiseAbs().maxCoeff());
  return place.unaryExpr([size](double x) { return std::abs(x) < size ? 0.0 : x; });
}

/// A length as messages tell it, without what is rounding. Part unit.
[[nodiscard]] inline double told(double length) {
  constexpr double rounding = 1e-9;
  return std::abs(length) < rounding ? 0.0 : length;
}

}  // namespace arelem::motion
