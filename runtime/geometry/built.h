#pragma once
#include <memory>
#include <span>

#include "ir/geometry/entity.h"

namespace arelem::surface {

/// What queries on a surface need and what takes long to make of its canonical form, for
/// Entity::built: of a MESH its tree, of a RLDSRF or POLCON its tables. Null for other kinds.
[[nodiscard]] std::shared_ptr<const void> builtOf(EntityType type, std::span<const double> canon);

}  // namespace arelem::surface
