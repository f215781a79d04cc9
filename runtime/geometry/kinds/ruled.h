#pragma once
#include <memory>

#include "runtime/geometry/kinds/sheet.h"
#include "runtime/geometry/ruled_surface.h"
#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// RLDSRF: rulings without end through the places of equal fraction f of two curves. Where a curve
/// leaves its subsurface, at the latest one chord beyond its end points, the surface goes on along
/// its tangents there. Positive on the side of byF x byG (geometry::RuledPoint).
class Ruled {
 public:
  struct Hint {
    bool valid = false;
    double f = 0.0, g = 0.0;          ///< of the last foot
    double nearF = 0.0, nearG = 0.0;  ///< where the sheet was looked at last, next to it,
    SheetPlace near{};                ///< and what it is like there
  };
  class Sheet;

  explicit Ruled(const geometry::RuledSurface& surface);

  /// Newton on f and g from the hint; without one from the best of many rulings, whose feet count
  /// up to one curve distance outside the strip.
  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  [[nodiscard]] Vec3 turn(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const {
    return t.dot(turn(p, foot, t, hint));
  }

  /// Along the ruling through the foot of p, not of unit length.
  [[nodiscard]] Vec3 ruling(const Vec3& p) const;

  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius) const;
  /// `hint` is that of the foot.
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius, const Hint& hint) const;

 private:
  std::shared_ptr<const Sheet> sheet_;
};

}  // namespace arelem::surface
