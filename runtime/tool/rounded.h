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

/// True where the directions of the profile turn one way, from the tool end to the top.
[[nodiscard]] inline bool isConvex(const Profile& p) {
  constexpr double rounding = 1e-9;
  const double bottom = std::atan2(p.bottomEnd.z, p.bottomEnd.rho);
  const double side = std::atan2(p.sideEnd.rho - p.sideStart.rho, p.sideEnd.z - p.sideStart.z);
  const bool hasBottom = p.bottomEnd.rho > 0.0;
  const bool hasSide = p.sideEnd.z > p.sideStart.z;
  return !p.ring && (!hasBottom || (bottom >= -rounding && bottom <= p.alpha + rounding)) &&
         (!hasSide || (side >= -rounding && side <= p.beta + rounding));
}

/// True where the lower half of the cutter is a ball.
[[nodiscard]] inline bool isRoundBall(const Profile& p) {
  return p.isBall() && p.r > 0.0 && isRounded(p);
}

}  // namespace arelem::tool
