#pragma once
#include <optional>

/// How long a chord may be, and whether one stays in its tolerance band.
namespace arelem::motion {

/// A gap field seen along a chord of length `length`: values and slopes (per unit length) at both
/// ends.
struct ChordProfile {
  double gapFrom = 0.0, slopeFrom = 0.0;
  double gapTo = 0.0, slopeTo = 0.0;
  double length = 0.0;
};

/// Longest chord from gap `from` to gap `to` over a surface of constant curvature `bend` (positive:
/// bending away, so that the chord dips) that stays in [-inner, outer].
[[nodiscard]] double longestChord(double bend, double from, double to, double inner, double outer);

/// Factor by which to scale a chord's length so that it just fits the band; above 1 where there is
/// room. `first` and `second` are the two halves of the chord: contacts that jump between them show
/// in the middle.
[[nodiscard]] double fittingFactor(const ChordProfile& first,
                                   const ChordProfile& second,
                                   double inner,
                                   double outer);

}  // namespace arelem::motion
