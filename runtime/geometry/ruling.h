#pragma once
#include <optional>

#include "runtime/geometry/kinds.h"

namespace arelem::surface {

/// Unit direction of the straight line of a cylinder, cone or ruled surface that runs through the
/// foot of p. None for surfaces without straight lines and for planes, which have too many.
[[nodiscard]] std::optional<Vec3> rulingAt(const AnySurface& surface, const Vec3& p);

}  // namespace arelem::surface
