#pragma once

/// Tolerances of motion along surfaces and of its proof. Other fields: tolerance.h.
namespace arelem::tolerance {

/// OUTTOL before any statement. Part unit.
inline constexpr double defaultOutside = 0.0005;
/// A motion may begin outside its band by this share of the band and this length: the old system's
/// test (its number 503). Relative, and part unit.
inline constexpr double startShare = 0.2;
inline constexpr double startLength = 5e-5;
/// How much of a tolerance band the rounding of coordinates may be. Relative.
inline constexpr double roundingOfBand = 0.1;
/// A generatrix of a cutter whose angle with the axis has a smaller sine is a wall along the axis.
/// Dimensionless.
inline constexpr double wallAlongAxis = 1e-12;
/// Ends of an arc of a CL file may be this far off its circle: what four decimals take away. Part
/// unit.
inline constexpr double arcEnd = 0.0005;

}  // namespace arelem::tolerance
