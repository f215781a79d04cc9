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

/// A slope that changes by less over a cut vector does not change: a plane seen by a tool that
/// turns.
constexpr double levelChange = 1e-11;
/// Mean curvature between two places, by the slopes there.
[[nodiscard]] double meanCurvature(double before, double behind, double length);

/// Longest chord from gap `from` to gap `to` over a surface of constant curvature `bend` (positive:
/// bending away, so that the chord dips) that stays in [-inner, outer].
[[nodiscard]] double longestChord(double bend, double from, double to, double inner, double outer);

/// About the longest chord over a surface whose curvature is `bend` at its start and changes
/// evenly, by `trend` a length, that stays in [-inner, outer] from gap `from` to gap `to`; `guess`
/// is one to begin with. 0 where none is found.
[[nodiscard]] double longestSway(
    double bend, double trend, double from, double to, double inner, double outer, double guess);

/// True where the cubic through `a` and `b` foretells `between`, a node between them, but for
/// `tolerance`: the gap is smooth there, and cubics through all three err by a sixteenth of that.
[[nodiscard]] bool foretold(const GapNode& a,
                            const GapNode& b,
                            const GapNode& between,
                            double tolerance);

/// Where the tangents at two nodes cross, or the middle: there a gap whose contact jumps from one
/// place of the cutter to another has its ridge.
[[nodiscard]] double crossing(const GapNode& a, const GapNode& b);

/// The straight line from the gap at one end of a chord to that at the other.
struct GapLine {
  double along = 0.0;  ///< where it starts
  double gap = 0.0;
  double steepness = 0.0;

  GapLine() = default;
  GapLine(const GapNode& first, const GapNode& last)
      : along(first.along),
        gap(first.gap),
        steepness((last.gap - first.gap) / (last.along - first.along)) {}
  [[nodiscard]] double at(double place) const { return gap + steepness * (place - along); }
};

/// Square of the factor by which to scale the length of a chord with these ends so that its part
/// between `a` and `b` just fits the band; above 1 where there is room.
[[nodiscard]] double squaredFit(
    const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer);

/// How far that part of a chord leaves the line between its ends where it is most outside the band:
/// positive where the gap is below the line.
[[nodiscard]] double swerve(
    const GapLine& ends, const GapNode& a, const GapNode& b, double inner, double outer);

}  // namespace arelem::motion
