#pragma once

/// Every numeric tolerance of the project, named, with its unit. No other file holds a bare 1e-x.
namespace arelem::tolerance {

/// A direction whose components are all at most this is null (the old system's zero test). Dimensionless.
inline constexpr double nullDirection = 1e-6;
/// Two places nearer than this coincide, and two curves this near are tangent. Part unit.
inline constexpr double coincidence = 1e-5;
/// Parallelism of lines and planes in DISTF: largest difference of normal components. Dimensionless.
inline constexpr double parallel = 1e-8;
/// An exponent this near a whole number is that number. Dimensionless.
inline constexpr double wholeExponent = 1e-6;
/// Relative rounding allowance for values computed from doubles of size one.
inline constexpr double rounding = 1e-14;

}  // namespace arelem::tolerance
