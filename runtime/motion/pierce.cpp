#include "runtime/motion/pierce.h"

#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/motion/field.h"

namespace arelem::motion {

namespace {
constexpr int pierceLimit = 500;
}  // namespace

std::optional<double> pierce(const surface::AnySurface& surface, const Vec3& from, const Vec3& v) {
  const auto field = makeField(surface, 1.0, {});
  double s = 0.0;
  for (int i = 0; i < pierceLimit; ++i) {
    const tool::Contact c = field->at(from + s * v, v);
    const double gap = std::abs(c.gap);
    if (gap <= tolerance::coincidence) {
      return s;
    }
    // On a plane the ray's own slope is known; elsewhere the distance is free of surface.
    const double rate = field->flat() ? std::abs(c.normal.dot(v)) : 1.0;
    const bool leaving = field->flat() && c.gap * c.normal.dot(v) >= 0.0;
    if (leaving || gap / rate > tolerance::farAway) {
      return std::nullopt;
    }
    s += gap / rate;
  }
  return std::nullopt;
}

}  // namespace arelem::motion
