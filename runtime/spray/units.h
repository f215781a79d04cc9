#pragma once

/// Units of process quantities. Inside the room: mm, s, mm3/s, radians.
namespace arelem::spray {

inline constexpr double cubicMillimetersPerLiter = 1e6;
/// 1 l/min in mm3/s.
inline constexpr double literPerMinute = cubicMillimetersPerLiter / 60.0;
/// 1 ml/min in mm3/s.
inline constexpr double milliliterPerMinute = 1e3 / 60.0;
inline constexpr double secondsPerHour = 3600.0;

}  // namespace arelem::spray
