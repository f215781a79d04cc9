#pragma once
#include <cmath>

#include "ir/space/vector.h"

namespace arelem::motion {

/// The unit vector in the direction of `v`; of one that is a unit vector up to rounding, itself, so
/// that what was written and is read again stays as it is.
[[nodiscard]] inline Vec3 writtenUnit(const Vec3& v) {
  constexpr double rounding = 1e-15;  // of the square of a length that is 1
  const double square = v.squaredNorm();
  return std::abs(square - 1.0) <= rounding ? v : Vec3(v / std::sqrt(square));
}

}  // namespace arelem::motion
