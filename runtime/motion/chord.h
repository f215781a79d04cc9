#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

/// How long a chord may be, and whether one stays in its tolerance band.
namespace arelem::motion {

/// A slope that changes by less over a cut vector does not change: a plane seen by a tool that
/// turns.
inline constexpr double levelChange = 1e-11;
/// Mean curvature between two places, by the slopes there.
[[nodiscard]] inline double meanCurvature(double before, double behind, double length) {
  const double change = behind - before;
  return std::abs(change) <= levelChange ? 0.0 : change / length;
}

/// Longest chord from gap `from` to gap `to` over a surface of constant curvature `bend` (positive:
/// bending away, so that the chord dips) that stays in [-inner, outer].
[[nodiscard]] inline double longestChord(
    double bend, double from, double to, double inner, double outer) {
  if (bend == 0.0) {
    return std::numeric_limits<double>::infinity();
  }
  // The parabola over a chord touches the band's edge where the two square roots meet.
  const double a = bend > 0.0 ? from + inner : outer - from;
  const double b = bend > 0.0 ? to + inner : outer - to;
  return (std::sqrt(std::max(a, 0.0)) + std::sqrt(std::max(b, 0.0))) *
         std::sqrt(2.0 / std::abs(bend));
}

/// About the longest chord over a surface whose curvature is `bend` at its start and changes
/// evenly, by `trend` a length, that stays in [-inner, outer] from gap `from` to gap `to`; `guess`
/// is one to begin with. 0 where none is found.
[[nodiscard]] double longestSway(
    double bend, double trend, double from, double to, double inner, double outer, double guess);

}  // namespace arelem::motion
