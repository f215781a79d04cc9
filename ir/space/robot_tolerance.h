#pragma once

/// Tolerances of robots and their programs. Other fields: tolerance.h.
namespace arelem::tolerance {

/// Coordinates and angles of three decimals. mm, degrees.
inline constexpr double writtenDigit = 1e-3;
/// Speeds of three decimals, mm/s.
inline constexpr double writtenSpeed = 1e-3;
/// Waits of three decimals, s.
inline constexpr double writtenTime = 1e-3;
/// Two locations of a program are one place: rounding of sums of numbers with three decimals. mm,
/// and difference of unit directions.
inline constexpr double writtenPlace = 1e-6;
/// Reaches, joints and speeds may pass their limits by this much. mm, degrees; relative for speeds.
inline constexpr double jointLimit = 1e-9;
/// The same where a mean over a window of the path was taken before. mm, degrees.
inline constexpr double meanJointLimit = 1e-6;
/// A tool that leans less stands upright; tilts may pass their limit by this. Degrees.
inline constexpr double uprightLean = 1e-4;
/// A tool axis whose horizontal part is at most this is vertical. Dimensionless.
inline constexpr double uprightAxis = 1e-6;
/// A sine of the pitch at most this leaves one of yaw and roll free. Dimensionless.
inline constexpr double singularPitch = 1e-9;
/// How far a side may lean out of the plane of the tilt. Dimensionless.
inline constexpr double sideOfTilt = 1e-6;
/// A move shorter than this is a turn on the spot. mm.
inline constexpr double onTheSpot = 1e-6;
/// The smallest range that an axis of a plot shows, and what a tick may lie beyond its end; in the
/// unit of the axis.
inline constexpr double plotRange = 1e-6;
inline constexpr double plotTick = 1e-9;

}  // namespace arelem::tolerance
