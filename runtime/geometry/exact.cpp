#include "runtime/geometry/exact.h"

#include <cmath>
#include <limits>

#include <CGAL/Gmpq.h>

namespace arelem::geometry {

namespace {
using Exact = CGAL::Gmpq;

int signOf(const Exact& value) {
  return static_cast<int>(CGAL::sign(value));
}

/// The sign when rounding cannot have changed it: three operations, each off by half a unit in the
/// last place of a value of at most `magnitude`, and products that may have underflowed; else 0.
int certainSign(double value, double magnitude) {
  constexpr double unit = std::numeric_limits<double>::epsilon();
  const double bound = 4.0 * unit * magnitude + std::numeric_limits<double>::min();
  if (!(std::abs(value) > bound) || !std::isfinite(magnitude)) {
    return 0;
  }
  return value > 0.0 ? 1 : -1;
}
}  // namespace

int discriminantSign(double a, double b, double c) {
  const int certain = certainSign(b * b - a * c, b * b + std::abs(a * c));
  return certain != 0 ? certain : signOf(Exact(b) * Exact(b) - Exact(a) * Exact(c));
}

int sideOfLine(double a, double b, double d, double x, double y) {
  const double magnitude = std::abs(a * x) + std::abs(b * y) + std::abs(d);
  const int certain = certainSign(a * x + b * y - d, magnitude);
  return certain != 0 ? certain : signOf(Exact(a) * Exact(x) + Exact(b) * Exact(y) - Exact(d));
}

int turn(double ax, double ay, double bx, double by, double cx, double cy) {
  const double left = (bx - ax) * (cy - ay);
  const double right = (by - ay) * (cx - ax);
  const int certain = certainSign(left - right, std::abs(left) + std::abs(right));
  if (certain != 0) {
    return certain;
  }
  return signOf((Exact(bx) - Exact(ax)) * (Exact(cy) - Exact(ay)) -
                (Exact(by) - Exact(ay)) * (Exact(cx) - Exact(ax)));
}

}  // namespace arelem::geometry
