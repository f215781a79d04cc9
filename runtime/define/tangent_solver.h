#pragma once
#include <optional>
#include <vector>

#include "ir/diag/result.h"

namespace arelem::define {

/// Chords of a curve: length and direction angle (radians, continuous from chord to chord).
struct Chord {
  double length = 0.0;
  double angle = 0.0;
};

/// The tangent angle at each of chords.size() + 1 points: where `fixed` is set it is kept, inside
/// it is found such that the curvature is continuous, at free ends it mirrors the neighbor's in the
/// chord. `angles` holds first guesses. Newton's method on the tridiagonal system, damped. None
/// where it does not converge from these guesses; fails where a tangent lies across its chord.
[[nodiscard]] Result<std::optional<std::vector<double>>> solveTangents(
    const std::vector<Chord>& chords,
    const std::vector<bool>& fixed,
    const std::vector<double>& angles);

/// Tangents for points through which no such curve is found: each in turn is moved so that its own
/// jump of curvature shrinks, as the old system does, as long as that helps.
struct RelaxedTangents {
  std::vector<double> angles;
  double jump = 0.0;      ///< largest jump of curvature left; 0 where none can be seen
  std::size_t worst = 0;  ///< its point, from 0
};
[[nodiscard]] RelaxedTangents relaxTangents(const std::vector<Chord>& chords,
                                            const std::vector<bool>& fixed,
                                            const std::vector<double>& angles);

/// Tangents may be off a chord by less than this (degrees).
inline constexpr int largestTangentAngle = 89;

}  // namespace arelem::define
