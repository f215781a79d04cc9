#include "runtime/geometry/ruling.h"

#include "ir/space/tolerance.h"

namespace arelem::surface {

namespace {
Vec3 lineOf(const Cone& s, const Vec3& p) {
  Cone::Hint hint;
  const Foot foot = s.foot(p, hint);
  return p - foot.distance * foot.normal - s.vertex;
}
Vec3 lineOf(const Ruled& s, const Vec3& p) {
  return s.ruling(p);
}
template <class S>
Vec3 lineOf(const S& s, const Vec3&) {
  return generatrix(s);
}
}  // namespace

std::optional<Vec3> rulingAt(const AnySurface& surface, const Vec3& p) {
  const Vec3 line = std::visit([&](const auto& s) { return lineOf(s, p); }, surface);
  const double length = line.norm();
  return length > tolerance::symmetric ? std::optional<Vec3>(line / length) : std::nullopt;
}

}  // namespace arelem::surface
