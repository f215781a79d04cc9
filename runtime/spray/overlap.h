#pragma once
#include "runtime/spray/profile.h"

namespace arelem::spray {

/// How far the film between parallel passes departs from its mean, relative to the mean
/// (Bartlett 4.3): R1 the mean of |h - 1|, R2 the root of the mean square, R3 the largest.
struct Uniformity {
  double average = 0.0;  ///< R1
  double rms = 0.0;      ///< R2
  double largest = 0.0;  ///< R3
};

/// Passes lie s = 2 b (1 - overlap) apart. The film at distance y = t s from a pass (0 <= t <= 1),
/// relative to the mean film; every pass that reaches the place counts. Source: Bartlett 2.10.
[[nodiscard]] double intervalFilm(const Profile& profile, double overlap, double t);

/// Exact within about 1e-9 for 0 <= overlap < 1. The source sums over a few points, which moves the
/// optimum of R1 and R2 by up to one per cent of overlap (formulas 1).
[[nodiscard]] Uniformity uniformity(const Profile& profile, double overlap);

enum class Measure : std::uint8_t { average, rms, largest };

/// The overlap of the smallest R1, R2 or R3 between 0 and 1/2, where no place is met by more than
/// two passes; more passes are always more uniform. For a uniform ellipse 0.17527, 0.15953,
/// 0.18115.
[[nodiscard]] double optimalOverlap(const Profile& profile, Measure measure);

}  // namespace arelem::spray
