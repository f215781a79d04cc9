#include "runtime/geometry/angle.h"

#include <cmath>
#include <numbers>

namespace arelem::geometry {

SinCos sinCosDegrees(double degrees) {
  // Reduction by quarter turns is exact in doubles; extended precision then rounds sin 30 to 0.5.
  const double turn = std::fmod(degrees, 360.0);
  const double quarters = std::round(turn / 90.0);
  const long double rest =
      static_cast<long double>(turn - 90.0 * quarters) * std::numbers::pi_v<long double> / 180.0L;
  const auto s = static_cast<double>(std::sin(rest));
  const auto c = static_cast<double>(std::cos(rest));
  switch ((static_cast<int>(quarters) % 4 + 4) % 4) {
    case 1:
      return {c, 0.0 - s};
    case 2:
      return {0.0 - s, -c};
    case 3:
      return {-c, s};
    default:
      return {s, c};
  }
}

SinCos sinCosOfTangent(double tangent) {
  const double length = std::hypot(1.0, tangent);
  return {tangent / length, 1.0 / length};
}

}  // namespace arelem::geometry
