#pragma once
#include "runtime/geometry/kinds.h"

namespace arelem::surface {

/// The straight ends of a TABCYL have a length in its canonical form, behind which there is no
/// surface. How long the end is behind which p lies; 0 where p lies behind none, and for kinds
/// without ends.
[[nodiscard]] double endBefore(const AnySurface& surface, const Vec3& p);

}  // namespace arelem::surface
