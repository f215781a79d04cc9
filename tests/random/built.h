#pragma once
#include <string>

#include "runtime/geometry/kinds.h"
#include "tests/random/shape.h"

namespace arelem::scenes {

/// The surface of a shape as drawn, from its canonical numbers.
[[nodiscard]] surface::AnySurface built(const Shape& shape);

/// Signed distance and normal of the surface of a shape at a place.
[[nodiscard]] surface::Foot footOf(const Shape& shape, const Vec3& place);

}  // namespace arelem::scenes
