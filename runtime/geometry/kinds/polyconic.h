#pragma once
#include <memory>

#include "runtime/geometry/surface.h"

namespace arelem::geometry {
class Polyconic;
}  // namespace arelem::geometry

namespace arelem::surface {

/// POLCON: conics in parallel planes (geometry::Polyconic). Positive on the side of the direction
/// of the conics times that of growing d, as the old system's normal.
class Polyconic {
 public:
  struct Hint {
    bool valid = false;
    double s = 0.0, t = 0.0;  ///< of the last foot
  };
  class Sheet;

  explicit Polyconic(const geometry::Polyconic& surface);

  /// Newton on s and t from the hint; without one from the nearest of many places.
  [[nodiscard]] Foot foot(const Vec3& p, Hint& hint) const;
  [[nodiscard]] Vec3 turn(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const;
  [[nodiscard]] double bend(const Vec3& p, const Foot& foot, const Vec3& t, Hint& hint) const {
    return t.dot(turn(p, foot, t, hint));
  }
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius) const;
  /// `hint` is that of the foot.
  [[nodiscard]] Bends bends(const Vec3& p, const Foot& foot, double radius, const Hint& hint) const;

 private:
  std::shared_ptr<const Sheet> sheet_;
};

}  // namespace arelem::surface
