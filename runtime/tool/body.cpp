#include "runtime/tool/body.h"

#include <algorithm>

namespace arelem::tool {

namespace {
/// Distances below this have no direction of their own. Part unit.
constexpr double touching = 1e-11;
}  // namespace

Body::Away Body::byProfile(double rho, double z) const {
  ProfilePoint q;
  Away result;
  result.distance = distanceTo(cutter_, {rho, z}, q);
  result.onRho = q.rho;
  result.onZ = q.z;
  result.byRho = rho - q.rho;
  result.byZ = z - q.z;
  if (std::abs(result.distance) <= touching) {
    // The direction in which the distance grows, from places around.
    ProfilePoint ignored;
    const double h = 1e-6 * (1.0 + cutter_.maxRadius());
    result.byRho = distanceTo(cutter_, {rho + h, z}, ignored) -
                   distanceTo(cutter_, {std::max(rho - h, 0.0), z}, ignored);
    result.byZ =
        distanceTo(cutter_, {rho, z + h}, ignored) - distanceTo(cutter_, {rho, z - h}, ignored);
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
