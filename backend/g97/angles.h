#pragma once
#include <optional>

#include "ir/space/vector.h"

/// The hand angles of G97 programs (Sen 4.4).
namespace arelem::backend::g97 {

/// Turns about X, Y, Z in degrees.
struct Angles {
  double p = 0.0, q = 0.0, r = 0.0;
};

/// How the source is read: its 4.4 turns about the axes as they have been turned, M = Rx(P) Ry(Q)
/// Rz(R); its 4.2 about those of the work, M = Rz(R) Ry(Q) Rx(P). Only the first agrees with its
/// statement that R does not turn the gun's direction.
enum class Reading : std::uint8_t { moving, fixed };

using Matrix3 = Eigen::Matrix3d;
[[nodiscard]] Matrix3 matrixOf(const Angles& angles, Reading reading);

/// Angles of a tool whose z is `axis` (from the work to the gun) and, if given, whose x is `side`
/// seen square to the axis; without a side R is 0. All quadrants; |Q| <= 90, P and R above -180 and
/// at most 180.
[[nodiscard]] Angles anglesOf(const Vec3& axis, const std::optional<Vec3>& side, Reading reading);

/// The source's (11) and (12) with R = 0: right only where one of the first two components is 0;
/// they miss the axis by 9.7 degrees for (1, 1, 1). None where the third component is not above 0.
[[nodiscard]] std::optional<Angles> sourceAngles(const Vec3& axis);

}  // namespace arelem::backend::g97
