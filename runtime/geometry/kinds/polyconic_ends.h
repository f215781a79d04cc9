#pragma once
#include "runtime/geometry/kinds/polyconic.h"

namespace arelem::surface {

/// How long the straight end is behind which a place next to the surface lies, or before which its
/// conics shrink; 0 where it lies behind none.
[[nodiscard]] double endBefore(const Polyconic& surface, const Vec3& p);

}  // namespace arelem::surface
