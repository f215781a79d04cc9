#pragma once
#include <limits>

#include "runtime/geometry/kinds/cone.h"

namespace arelem::surface {

/// How far around a place what is known of the distance there foretells it: behind the plane from
/// which on the tip of a cone is nearest the distance is another function, whose bend jumps. Part
/// unit.
template <Surface S>
[[nodiscard]] double sameForm(const S&, const Vec3&) {
  return std::numeric_limits<double>::infinity();
}
[[nodiscard]] inline double sameForm(const Cone& s, const Vec3& p) {
  const Vec3 w = p - s.vertex;
  const double along = w.dot(s.axis);
  return std::abs(along * s.cosHalf + (w - along * s.axis).norm() * s.sinHalf);
}

}  // namespace arelem::surface
