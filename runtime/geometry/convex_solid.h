#pragma once
#include <type_traits>

#include "runtime/geometry/kinds.h"

namespace arelem::surface {

/// True where the solid on the negative side is convex; then the distance is a convex function. Not
/// asked of spheres, which are one point and a radius.
template <Surface S>
[[nodiscard]] bool isConvexSolid(const S& s) {
  if constexpr (requires { s.isConvex(); }) {
    return s.isConvex();
  } else {
    return std::is_same_v<S, Cylinder> || std::is_same_v<S, Cone>;
  }
}

}  // namespace arelem::surface
