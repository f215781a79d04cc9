#include "runtime/geometry/roots.h"

#include <algorithm>
#include <cmath>

#include "runtime/geometry/exact.h"

namespace arelem::geometry {

QuadraticRoots solveQuadratic(double a, double b, double c) {
  if (a == 0.0) {
    return b == 0.0 ? QuadraticRoots{} : QuadraticRoots{1, -c / (2.0 * b), 0.0};
  }
  const int sign = discriminantSign(a, b, c);
  if (sign < 0) {
    return {};
  }
  if (sign == 0) {
    return {1, -b / a, 0.0};
  }
  // fma keeps the discriminant accurate where the products cancel (Kahan).
  const double product = a * c;
  const double lost = std::fma(-a, c, product);
  const double discriminant = std::max(std::fma(b, b, -product) + lost, 0.0);
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  const double one = q / a;
  const double two = q == 0.0 ? -one : c / q;
  return {2, std::min(one, two), std::max(one, two)};
}

}  // namespace arelem::geometry
