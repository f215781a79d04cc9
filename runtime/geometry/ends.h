#pragma once
#include "runtime/geometry/kinds.h"

namespace arelem::surface {

/// Whether a surface ends somewhere.
[[nodiscard]] inline bool mayEnd(const AnySurface& surface) {
  return std::holds_alternative<TabulatedCylinder>(surface) ||
         std::holds_alternative<Ruled>(surface) || std::holds_alternative<Polyconic>(surface);
}

/// The straight ends of a TABCYL have a length in its canonical form, behind which there is no
/// surface; the rulings of a RLDSRF and the tangents of its arcs go on for a length too, and so do
/// a POLCON and the tangents of its conics. How long the end is behind which p, a place of the
/// surface, lies; 0 where it lies behind none, and for kinds without ends.
[[nodiscard]] double endBefore(const AnySurface& surface, const Vec3& p);

}  // namespace arelem::surface
