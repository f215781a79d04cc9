#include "runtime/geometry/surface.h"

namespace arelem::surface {

/// The parallel surface at distance d has the normal curvature k / (1 + d k), which grows with k
/// and falls with d, as far as 1 + d k > 0, which holds for the distance to the nearest point.
/// Along the normal nothing bends.
Bends bendsOfCurvature(const Bends& curvature, double distance, double radius, bool single) {
  Bends b = bendsOfAnySet(distance, radius);
  const double near = 1.0 + curvature.high * (distance - radius);
  if ((single || distance > radius) && std::isfinite(curvature.high) && near > 0.0) {
    b.high = std::min(b.high, std::max(0.0, curvature.high / near));
  }
  const double far = 1.0 + curvature.low * (distance + radius);
  if ((single || distance < -radius) && std::isfinite(curvature.low) && far > 0.0) {
    b.low = std::max(b.low, std::min(0.0, curvature.low / far));
  }
  return b;
}

}  // namespace arelem::surface
