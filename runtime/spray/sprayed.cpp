#include "runtime/spray/sprayed.h"

namespace arelem::spray {

GunPose Sprayed::beginOf(const Stroke& stroke) const {
  const Vec3 way = stroke.to - stroke.from;
  const double length = way.norm();
  const double early = stroke.painting && length > 0.0 ? stroke.speed * gun.leadOn / length : 0.0;
  return {stroke.from - early * way + gun.standOff * stroke.normalFrom, stroke.normalFrom};
}

GunPose Sprayed::endOf(const Stroke& stroke) const {
  return {stroke.to + gun.standOff * stroke.normalTo, stroke.normalTo};
}

}  // namespace arelem::spray
