#include "runtime/spray/sprayed.h"

namespace arelem::spray {

GunPose Sprayed::beginOf(const Stroke& stroke) const {
  const Vec3 step = stroke.to - stroke.from;
  const double length = step.norm();
  const double early = stroke.painting && length > 0.0 ? stroke.speed * gun.leadOn / length : 0.0;
  return {stroke.from - early * step + gun.standOff * stroke.normalFrom, stroke.normalFrom};
}

GunPose Sprayed::endOf(const Stroke& stroke) const {
  return {stroke.to + gun.standOff * stroke.normalTo, stroke.normalTo};
}

}  // namespace arelem::spray
