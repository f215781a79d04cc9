#pragma once
#include <cmath>
#include <optional>

#include "ir/space/vector.h"

/// Small turns of unit vectors without roots, quotients and circular functions, which is most of
/// what a contact near the last one costs. Private to runtime/tool.
namespace arelem::tool {

/// Up to here the series of sine and cosine, and of the root next to 1, are exact. Radians; and
/// dimensionless.
inline constexpr double seriesTurn = 0.03;
inline constexpr double seriesRoot = 5e-5;

/// A unit vector square to a unit axis, turned about it by an angle; none where that is too large
/// for the series.
[[nodiscard]] inline std::optional<Vec3> smallTurn(const Vec3& v, const Vec3& axis, double angle) {
  if (std::abs(angle) > seriesTurn) {
    return std::nullopt;
  }
  const double a = angle * angle;
  const double cosine = 1.0 - a / 2.0 * (1.0 - a / 12.0 * (1.0 - a / 30.0 * (1.0 - a / 56.0)));
  const double sine = angle * (1.0 - a / 6.0 * (1.0 - a / 20.0 * (1.0 - a / 42.0)));
  return cosine * v + sine * axis.cross(v);
}

/// The unit vector along one that may be nearly of that length already.
[[nodiscard]] inline Vec3 unitOf(const Vec3& v, double squaredNorm) {
  const double over = squaredNorm - 1.0;
  if (std::abs(over) <= seriesRoot) {
    return v * (1.0 - over * (0.5 - over * (0.375 - over * 0.3125)));
  }
  return v / std::sqrt(squaredNorm);
}
[[nodiscard]] inline Vec3 unitOf(const Vec3& v) {
  return unitOf(v, v.squaredNorm());
}

}  // namespace arelem::tool
