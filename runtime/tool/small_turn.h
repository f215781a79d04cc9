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

/// Cosine and sine of an angle that mostly is small.
struct Turn {
  static constexpr double by6 = 1.0 / 6.0, by24 = 1.0 / 24.0, by120 = 1.0 / 120.0;
  static constexpr double by720 = 1.0 / 720.0, by5040 = 1.0 / 5040.0;
  double cosine, sine;
  explicit Turn(double angle) {
    if (std::abs(angle) > seriesTurn) {
      cosine = std::cos(angle);
      sine = std::sin(angle);
      return;
    }
    const double a = angle * angle;
    cosine = 1.0 - a * (0.5 - a * (by24 - a * by720));
    sine = angle * (1.0 - a * (by6 - a * (by120 - a * by5040)));
  }
};

/// A unit vector square to a unit axis, turned about it by an angle; none where that is too large
/// for the series.
[[nodiscard]] inline std::optional<Vec3> smallTurn(const Vec3& v, const Vec3& axis, double angle) {
  if (std::abs(angle) > seriesTurn) {
    return std::nullopt;
  }
  const Turn t(angle);
  return t.cosine * v + t.sine * axis.cross(v);
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

/// The normal at a contact inside a level bottom: a search that is kept near the axis where the
/// surface is flat ends this far beside that. Tool axes that are to follow normals would creep.
[[nodiscard]] inline Vec3 levelled(const Vec3& normal, const Vec3& axis) {
  constexpr double beside = 2e-9;
  const double up = std::copysign(1.0, normal.dot(axis));
  return (normal - up * axis).squaredNorm() <= beside * beside ? Vec3(up * axis) : normal;
}

}  // namespace arelem::tool
