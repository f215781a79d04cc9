#include "ir/space/degrees.h"

#include <cmath>
#include <numbers>

namespace arelem {

namespace {
/// Sine and cosine of an angle within 45 degrees of zero, with the half at 30 degrees made exact.
SineCosine ofSmallAngle(double angle) {
  const double a = radians(angle);
  const double sine = std::abs(angle) == 30.0 ? std::copysign(0.5, angle) : std::sin(a);
  return {sine, std::cos(a)};
}
}  // namespace

double radians(double degrees) {
  return degrees * (std::numbers::pi / 180.0);
}
double degrees(double radians) {
  return radians * (180.0 / std::numbers::pi);
}

SineCosine sineCosine(double degrees) {
  // degrees = 90 n + rest with |rest| <= 45; remquo gives the low bits of n exactly.
  int n = 0;
  const double rest = std::remquo(degrees, 90.0, &n);
  const auto [s, c] = ofSmallAngle(rest);
  switch (n & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, 0.0 - s};
    case 2:
      return {0.0 - s, 0.0 - c};
    default:
      return {0.0 - c, s};
  }
}

}  // namespace arelem
