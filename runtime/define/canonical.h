#pragma once
#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "runtime/geometry/shapes.h"

namespace arelem::define {

/// Checks numbers given as the canonical form of a type and brings directions to unit length (of a plane, all
/// four numbers are divided). Old errors 84 (count) and 1005.
[[nodiscard]] Result<geometry::Canon> checkedCanon(EntityType type, geometry::Canon canon);

}  // namespace arelem::define
