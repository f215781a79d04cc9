#pragma once
#include <cstddef>
#include <vector>

#include "ir/space/vector.h"

namespace arelem::spray {

/// Where the nozzle is, mm, and the direction from there into the gun.
struct GunPose {
  Vec3 place = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
};

/// Places on the way to a line, where straight on the gun would come too near to the work.
struct WayRound {
  std::size_t stroke = 0;  ///< the first of the line
  std::vector<GunPose> poses;
};

}  // namespace arelem::spray
