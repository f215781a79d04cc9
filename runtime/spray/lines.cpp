#include "runtime/spray/lines.h"

#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::spray {

LineCount lineCount(double length, double widest) {
  // A length that is a whole number of steps but for rounding needs no step more.
  const double count = std::ceil(length / widest * (1.0 - tolerance::rounding * 8.0));
  const int intervals = count < 1.0 ? 1 : static_cast<int>(count);
  return {intervals, length / intervals};
}

double speedFor(double flow, double efficiency, double film, double step) {
  return flow * efficiency / (film * step);
}

double spotFilm(double flow, double efficiency, double seconds, double radius) {
  return flow * efficiency * seconds / (std::numbers::pi * radius * radius);
}

}  // namespace arelem::spray
