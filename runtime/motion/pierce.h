#pragma once
#include <optional>

#include "runtime/geometry/kinds.h"

namespace arelem::motion {

/// The distance from a place along the unit direction `v` to a surface. None where the ray misses
/// it, or meets it farther off than `tolerance::farAway`.
[[nodiscard]] std::optional<double> pierce(const surface::AnySurface& surface,
                                           const Vec3& from,
                                           const Vec3& v);

}  // namespace arelem::motion
