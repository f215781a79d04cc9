#pragma once

/// How exactly CL files are printed: what is nearer than this is meant to be the same.
namespace arelem::tolerance {

/// Places have four decimals at least; part unit. The worst of 16 000 arcs misses by 0.0002.
inline constexpr double printedPlace = 5e-4;
/// Components of axes have four decimals at least.
inline constexpr double printedAxis = 2e-4;
/// Radians have six decimals.
inline constexpr double printedRadians = 6e-7;

}  // namespace arelem::tolerance
