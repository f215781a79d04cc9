#pragma once
#include "runtime/geometry/kinds/mesh.h"

namespace arelem::surface {

/// The foot of p on a mesh whose nearest triangle is known; `hint` becomes that of it.
[[nodiscard]] Foot footOn(const MeshShape& shape,
                          std::size_t triangle,
                          const Vec3& p,
                          Mesh::Hint& hint);

}  // namespace arelem::surface
