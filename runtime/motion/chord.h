#pragma once
#include <optional>

/// How long a chord may be, and whether one stays in its tolerance band.
namespace arelem::motion {

/// A gap field seen along a chord of length `length`: values and slopes (per unit length) at both ends.
struct ChordProfile {
  double gapFrom = 0.0, slopeFrom = 0.0;
  double gapTo = 0.0, slopeTo = 0.0;
  double length = 0.0;
};

/// Least and greatest gap over the chord by the cubic through both ends' values and slopes.
struct ChordRange {
  double least = 0.0, greatest = 0.0;
};
[[nodiscard]] ChordRange rangeOf(const ChordProfile& chord);

/// Longest chord from gap `from` to gap `to` over a surface of constant curvature `bend` (positive:
/// bending away, so that the chord dips) that stays in [-inner, outer].
[[nodiscard]] double longestChord(double bend, double from, double to, double inner, double outer);

/// Factor by which to scale a chord's length so that it just fits the band; above 1 where there is room.
[[nodiscard]] double fittingFactor(const ChordProfile& chord, double inner, double outer);

}  // namespace arelem::motion
