#pragma once
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
/// chord. `angles` holds first guesses. Newton's method on the tridiagonal system, damped. Fails
/// where it does not converge from these guesses.
[[nodiscard]] Result<std::vector<double>> solveTangents(const std::vector<Chord>& chords,
                                                        const std::vector<bool>& fixed,
                                                        const std::vector<double>& angles);

/// Tangents may be off a chord by less than this (degrees).
inline constexpr int largestTangentAngle = 89;

}  // namespace arelem::define
