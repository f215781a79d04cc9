#include "runtime/motion/check_pace.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/certify/cutter_probe.h"
#include "runtime/tool/rounded.h"

namespace arelem::motion {

namespace {
template <surface::Surface S>
bool bulges(const S& s) {
  return std::is_same_v<S, surface::Sphere> || certify::isConvexSolid(s);
}
}  // namespace

CheckPace::CheckPace(const surface::AnySurface& surface, const tool::Profile* cutter)
    : along_(surface::generatrix(surface)),
      convex_(std::visit([](const auto& s) { return bulges(s); }, surface)),
      convexCutter_(cutter == nullptr || tool::isConvex(*cutter)) {
  if (const auto* plane = std::get_if<surface::Plane>(&surface)) {
    kind_ = Kind::plane;
    along_ = plane->normal;
  } else if (const auto* cone = std::get_if<surface::Cone>(&surface)) {
    kind_ = Kind::cone;
    along_ = cone->axis;
    cosHalf_ = cone->cosHalf;
    sinHalf_ = cone->sinHalf;
  } else if (!along_.isZero()) {
    kind_ = Kind::lines;
  }
}

double CheckPace::closing(double side, double gap, double slope, const Vec3& direction) const {
  if (kind_ == Kind::plane) {
    return std::abs(slope);
  }
  const double toward = gap > 0.0 ? -slope : slope;
  // The distance of a solid that is convex rises ever faster, and falls ever slower.
  const bool slows = convex_ && (side > 0.0 ? convexCutter_ && gap > 0.0 : gap < 0.0);
  const bool rises = (gap < 0.0) == (side > 0.0);
  const double most = rising(rises ? direction : -direction);
  return slows ? std::min(most, std::max(toward, 0.0) + tolerance::symmetric) : most;
}

}  // namespace arelem::motion
