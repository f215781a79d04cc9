#include "runtime/spray/sprayed.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::spray {

double Sprayed::nozzleSpeed(const Stroke& stroke) const {
  const double d = gun.standOff;
  const double length = (stroke.to - stroke.from).norm();
  const double way = (stroke.to + d * stroke.normalTo - stroke.from - d * stroke.normalFrom).norm();
  // Rounded, so that the rounding of places makes no feeds of its own.
  const bool straight = !(length > 0.0) || std::abs(way / length - 1.0) <= tolerance::similarity;
  const double speed =
      straight ? stroke.speed : std::round(stroke.speed * way / length * 1e6) / 1e6;
  return !planar && gun.speed > 0.0 ? std::min(speed, gun.speed) : speed;
}

GunPose Sprayed::beginOf(const Stroke& stroke) const {
  const Vec3 way = stroke.to - stroke.from;
  const double length = way.norm();
  const double early =
      stroke.painting && length > 0.0 ? nozzleSpeed(stroke) * gun.leadOn / length : 0.0;
  return {stroke.from - early * way + gun.standOff * stroke.normalFrom, stroke.normalFrom};
}

GunPose Sprayed::endOf(const Stroke& stroke) const {
  return {stroke.to + gun.standOff * stroke.normalTo, stroke.normalTo};
}

}  // namespace arelem::spray
