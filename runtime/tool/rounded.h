#pragma once
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/tool/profile.h"

namespace arelem::tool {

/// True where the lines of the profile leave the corner arc as its tangents: what is nearest by a
/// normal of the arc is nearest of all.
[[nodiscard]] inline bool isRounded(const Profile& p) {
  const double aside = std::abs(p.bottomEnd.rho * p.sinAlpha - p.bottomEnd.z * p.cosAlpha) +
                       std::abs((p.sideEnd.rho - p.sideStart.rho) * p.cosBeta -
                                (p.sideEnd.z - p.sideStart.z) * p.sinBeta);
  return !p.ring && p.bottomEnd.rho >= 0.0 && p.sideEnd.z >= p.sideStart.z &&
         aside <= tolerance::sameSide;
}

/// True where the lower half of the cutter is a ball.
[[nodiscard]] inline bool isRoundBall(const Profile& p) {
  return p.isBall() && p.r > 0.0 && isRounded(p);
}

}  // namespace arelem::tool
