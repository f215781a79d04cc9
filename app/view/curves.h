#pragma once
#include "backend/backend.h"
#include "ir/geometry/entity.h"

namespace arelem::app {

/// What can be drawn of an entity as polylines in space: a path spline, the loops of a region. None
/// of others, which their numbers tell how to draw.
[[nodiscard]] backend::Curves curvesOf(const Entity& entity);

}  // namespace arelem::app
