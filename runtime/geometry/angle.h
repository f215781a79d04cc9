#pragma once

namespace arelem::geometry {

struct SinCos {
  double sin = 0.0, cos = 1.0;
};

/// Sine and cosine of an angle in degrees, exact where they are rational (multiples of 90 and 30
/// degrees).
[[nodiscard]] SinCos sinCosDegrees(double degrees);
/// Sine and cosine of the angle in (-90, 90) degrees with this tangent.
[[nodiscard]] SinCos sinCosOfTangent(double tangent);

}  // namespace arelem::geometry
