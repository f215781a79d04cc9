#include "runtime/tool/body.h"

#include <algorithm>

namespace arelem::tool {

namespace {
/// Distances below this have no direction of their own. Part unit.
constexpr double touching = 1e-11;
}  // namespace

double Body::distance(ProfilePoint place, ProfilePoint& nearest) const {
  const double distance = distanceTo(cutter_, place, nearest);
  const double above = place.z - cutter_.h;
  if (convex_ && (above >= 0.0 ? place.rho <= cutter_.sideEnd.rho : above > distance)) {
    nearest = {place.rho, cutter_.h};
    return above;
  }
  return distance;
}

Body::Away Body::byProfile(double rho, double z) const {
  ProfilePoint q;
  Away result;
  result.distance = distance({rho, z}, q);
  result.onRho = q.rho;
  result.onZ = q.z;
  result.byRho = rho - q.rho;
  result.byZ = z - q.z;
  if (std::abs(result.distance) <= touching) {
    // The direction in which the distance grows, from places around.
    ProfilePoint ignored;
    const double h = 1e-6 * (1.0 + cutter_.maxRadius());
    result.byRho = distance({rho + h, z}, ignored) - distance({std::max(rho - h, 0.0), z}, ignored);
    result.byZ = distance({rho, z + h}, ignored) - distance({rho, z - h}, ignored);
  } else if (result.distance < 0.0) {
    result.byRho = -result.byRho;
    result.byZ = -result.byZ;
  }
  const double length = std::sqrt(result.byRho * result.byRho + result.byZ * result.byZ);
  result.byRho = length > 0.0 ? result.byRho / length : 0.0;
  result.byZ = length > 0.0 ? result.byZ / length : -1.0;
  return result;
}

}  // namespace arelem::tool
