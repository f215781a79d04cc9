#pragma once

/// Tolerances of pictures. Other fields: tolerance.h.
namespace arelem::tolerance {

/// A direction with a component smaller than this along a coordinate axis is seen edge on.
/// Dimensionless.
inline constexpr double edgeOn = 1e-6;
/// A path thinner than this part of its size lies in a plane. Relative.
inline constexpr double flatPath = 1e-6;

}  // namespace arelem::tolerance
