#pragma once
#include <cmath>

/// Units of process quantities. Inside the room: mm, s, mm3/s, radians.
namespace arelem::spray {

inline constexpr double cubicMillimetersPerLiter = 1e6;
/// 1 l/min in mm3/s.
inline constexpr double literPerMinute = cubicMillimetersPerLiter / 60.0;
/// 1 ml/min in mm3/s.
inline constexpr double milliliterPerMinute = 1e3 / 60.0;
inline constexpr double secondsPerHour = 3600.0;

/// A flow of mm3/s as FLOW tells it in the CL: l/min, without the rounding of the conversion.
[[nodiscard]] inline double toldFlow(double flow) {
  constexpr double digits = 1e9;  // of l/min
  return std::round(flow / literPerMinute * digits) / digits;
}

}  // namespace arelem::spray
