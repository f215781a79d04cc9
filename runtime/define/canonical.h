#pragma once
#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "runtime/geometry/shapes.h"

namespace arelem::define {

/// Checks numbers given as the canonical form of a type: their count (old error 84), and that
/// radii, axes and curves can be used at all. They are kept as given, also where a normal is no
/// unit vector: programs use LINE/CANON to keep four numbers. The typed views of
/// runtime/geometry/shapes.h divide by the length.
[[nodiscard]] Result<geometry::Canon> checkedCanon(EntityType type, geometry::Canon canon);

}  // namespace arelem::define
