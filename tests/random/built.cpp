#include "tests/random/built.h"

#include <stdexcept>

#include "tests/random/motion.h"

namespace arelem::scenes {

surface::AnySurface built(const Shape& shape) {
  const Work work("S1=" + definition(shape, {}, "") + "\nFINI\n", "");
  const EntityPtr entity = work.entity("S1");
  if (!entity) {
    throw std::logic_error("a random surface is no surface: " + definition(shape, {}, ""));
  }
  return *surface::surfaceOf(*entity);
}

surface::Foot footOf(const Shape& shape, const Vec3& place) {
  return std::visit(
      [&](const auto& s) {
        typename std::decay_t<decltype(s)>::Hint hint{};
        return s.foot(place, hint);
      },
      built(shape));
}

}  // namespace arelem::scenes
