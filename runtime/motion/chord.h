#pragma once
#include <optional>

/// How long a chord may be, and whether one stays in its tolerance band.
namespace arelem::motion {

/// What is known of a gap at one place of a chord.
struct GapNode {
  double along = 0.0;  ///< length of the chord up to here
  double gap = 0.0;
  double slope = 0.0;  ///< of the gap, per length
};

/// Longest chord from gap `from` to gap `to` over a surface of constant curvature `bend` (positive:
/// bending away, so that the chord dips) that stays in [-inner, outer].
[[nodiscard]] double longestChord(double bend, double from, double to, double inner, double outer);

/// True where the cubic through `a` and `b` foretells `between`, a node between them, but for
/// `tolerance`: the gap is smooth there, and cubics through all three err by a sixteenth of that.
[[nodiscard]] bool foretold(const GapNode& a,
                            const GapNode& b,
                            const GapNode& between,
                            double tolerance);

/// Where the tangents at two nodes cross, or the middle: there a gap whose contact jumps from one
/// place of the cutter to another has its ridge.
[[nodiscard]] double crossing(const GapNode& a, const GapNode& b);

/// Factor by which to scale the length of a chord from `first` to `last` so that its part between
/// `a` and `b` just fits the band; above 1 where there is room.
[[nodiscard]] double fittingFactor(const GapNode& first,
                                   const GapNode& last,
                                   const GapNode& a,
                                   const GapNode& b,
                                   double inner,
                                   double outer);

}  // namespace arelem::motion
