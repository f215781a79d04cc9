#pragma once
#include "runtime/spray/profile.h"

namespace arelem::spray {

/// How far inside the edge of the work the outermost passes lie, relative to the footprint's half
/// width b (Bartlett 4.4).

/// Method one: the film at the very edge is the mean film. Error E0353 where one pass alone never
/// gives it (for an ellipse: overlap above 1 - pi/4).
[[nodiscard]] Result<double> insetByEdge(const Profile& profile, double overlap);
/// Method two: the mean film between the edge and the outermost pass is the mean film. The source's
/// (4.28) lost a factor 2 and gives 0.74 for an ellipse at overlap 0.175; right is 0.52473.
[[nodiscard]] Result<double> insetByMean(const Profile& profile, double overlap);
/// What the source's program uses.
inline constexpr double programInset = 0.75;

/// The film at the edge, and its mean from the edge to the outermost pass, relative to the mean
/// film, for an inset of `inset` b.
struct EdgeFilm {
  double atEdge = 0.0;
  double mean = 0.0;
};
[[nodiscard]] EdgeFilm edgeFilm(const Profile& profile, double overlap, double inset);

}  // namespace arelem::spray
