#pragma once
#include <span>
#include <string_view>
#include <variant>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "runtime/geometry/kinds/cone.h"
#include "runtime/geometry/kinds/cylinder.h"
#include "runtime/geometry/kinds/mesh.h"
#include "runtime/geometry/kinds/plane.h"
#include "runtime/geometry/kinds/polyconic.h"
#include "runtime/geometry/kinds/quadric.h"
#include "runtime/geometry/kinds/ruled.h"
#include "runtime/geometry/kinds/sphere.h"
#include "runtime/geometry/kinds/tabulated.h"
#include "runtime/geometry/kinds/torus.h"

namespace arelem::surface {

/// THE list of surface kinds. A new kind is one file and one word here.
template <Surface... Kinds>
using VariantOf = std::variant<Kinds...>;
using AnySurface = VariantOf<Plane,
                             Sphere,
                             Cylinder,
                             Cone,
                             Torus,
                             Quadric,
                             TabulatedCylinder,
                             Ruled,
                             Polyconic,
                             Mesh>;

/// The surface of an entity's canonical form; fails for what is no surface (POINT, VECTOR, ...).
[[nodiscard]] Result<AnySurface> surfaceOf(const Entity& entity);

/// What queries on a mesh need, from its canonical form; kept in Entity::built.
[[nodiscard]] std::shared_ptr<const MeshShape> builtMesh(std::span<const double> canon);

/// The direction along which a cylinder of any cross-section does not change; zero for other kinds.
template <Surface S>
[[nodiscard]] Vec3 generatrix(const S& s) {
  if constexpr (requires { s.generatrix(); }) {
    return s.generatrix();
  } else {
    return Vec3::Zero();
  }
}
[[nodiscard]] inline Vec3 generatrix(const AnySurface& surface) {
  return std::visit([](const auto& s) { return generatrix(s); }, surface);
}

}  // namespace arelem::surface
