#pragma once
#include "runtime/geometry/kinds.h"

namespace arelem::surface {

/// The rulings of a ruled surface count for ten distances of its curves beyond them, the tangents
/// of the curves for as long as takes one chord; motions end there. How long the end is behind
/// which p, a place of the surface, lies; 0 elsewhere.
[[nodiscard]] double endBefore(const Ruled& surface, const Vec3& p);

}  // namespace arelem::surface
