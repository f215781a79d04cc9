#pragma once

/// What programs of robots may differ by from what they were made of.
namespace arelem::tolerance {

/// Speeds of three decimals, mm/s.
inline constexpr double writtenSpeed = 1e-3;
/// Waits of three decimals, s.
inline constexpr double writtenTime = 1e-3;

}  // namespace arelem::tolerance
