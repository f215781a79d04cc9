#pragma once
#include <optional>

#include "backend/html/scene.h"
#include "runtime/geometry/kinds.h"

namespace arelem::app {

/// The part of any surface within a box as triangles: one vertex in each cell of a grid that the
/// surface passes (surface nets after Gibson 1998), moved onto the surface. Cells that are farther
/// from the surface than their size are never looked at, as distances are 1-Lipschitz. Nothing when
/// the surface does not pass the box.
[[nodiscard]] std::optional<backend::SceneMesh> meshOf(const surface::AnySurface& surface,
                                                       const Vec3& low,
                                                       const Vec3& high,
                                                       int cells);

}  // namespace arelem::app
