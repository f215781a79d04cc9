#pragma once

/// Every numeric tolerance of the project, named, with its unit. No other file holds a bare 1e-x.
namespace arelem::tolerance {

/// A direction whose components are all at most this is null (the old system's zero test).
/// Dimensionless.
inline constexpr double nullDirection = 1e-6;
/// Two places nearer than this coincide, and two curves this near are tangent. Part unit.
inline constexpr double coincidence = 1e-5;
/// Parallelism of lines and planes in DISTF: largest difference of normal components.
/// Dimensionless.
inline constexpr double parallel = 1e-8;
/// An exponent this near a whole number is that number. Dimensionless.
inline constexpr double wholeExponent = 1e-6;
/// Relative rounding allowance for values computed from doubles of size one.
inline constexpr double rounding = 1e-14;
/// A component of a unit direction at most this decides no modifier: it may be rounding.
/// Dimensionless.
inline constexpr double symmetric = 1e-9;
/// Unit normals whose determinant (sine of their angle) is at most this have no common point.
/// Dimensionless.
inline constexpr double singular = 1e-9;
/// Planes are perpendicular when the cosine of their angle is at most this. Dimensionless.
inline constexpr double perpendicular = 1e-6;
/// Scales of a matrix in different directions that differ by at most this, relative, are the same.
/// Dimensionless.
inline constexpr double similarity = 1e-9;
/// A coefficient of s^2 at most this, for surfaces of size one, makes a directed distance linear; a
/// direction that meets a plane at a sine of at most this does not meet it. Dimensionless.
inline constexpr double grazing = 1e-7;
/// A discriminant of at most this times a^2 is a double root of a directed distance. Square of the
/// part unit.
inline constexpr double doubleRoot = 1e-13;
/// A directed distance of at most this is 0. Part unit.
inline constexpr double zeroDistance = 1e-7;
/// End points of a curve of a ruled surface are more than this apart. Part unit.
inline constexpr double ruledChord = 0.032;
/// Largest jump of curvature left by a curvature-continuous fit, relative to one over the shortest
/// chord. Dimensionless.
inline constexpr double curvatureJump = 1e-9;
/// A whole number (a count, an index) may be off by this after arithmetic. Dimensionless.
inline constexpr double wholeNumber = 1e-6;

/// IF takes a difference this small against its right operand for zero: the rounding of a few
/// thousand decimal steps. Dimensionless.
inline constexpr double decimalStep = 1e-13;
/// What the certificate allows beyond a tolerance for rounding: this many part units, but at most
/// this share of the band of the surface, and at least this many part units all the same.
inline constexpr double certifiedSlack = 1e-6, certifiedShare = 0.01, certifiedLeast = 1e-9;
/// A tool nearer than this to a surface has no side of it. Part unit.
inline constexpr double sameSide = 1e-9;
/// Values of CUTTER are written with few decimals: corner arc and lines that miss each other by at
/// most this times the diameter (at least 1) are tangent. Relative.
inline constexpr double cutterRounding = 5e-6;
/// Up to this they still count as tangent, with a warning. Relative.
inline constexpr double cutterJoint = 1e-3;
/// Largest turn of the tool axis over one cut vector whose axis follows a surface. Radians.
inline constexpr double axisTurn = 0.1;
/// A ray or path that went this far without meeting a surface never meets it. Part unit.
inline constexpr double farAway = 1e7;

/// A DO loop runs once more when its counter passes the last value by at most this part of a step.
inline constexpr double loopCount = 1e-9;

/// Two overlaps of spray passes that differ by at most this are the same. Dimensionless.
inline constexpr double overlap = 1e-9;
/// A pass at most this far below the last useful height is not useful. mm.
inline constexpr double passHeight = 1e-9;
/// Pieces of a spray pass that are at most this apart are one: they share an edge. mm.
inline constexpr double passGap = 1e-7;
/// Process costs that differ by at most this, relative, are equal. Dimensionless.
inline constexpr double equalCost = 1e-9;
/// Corners of a region lie this near to one plane, times the region's size (at least 1).
/// Dimensionless.
inline constexpr double regionPlane = 1e-6;
/// Ends of curves of a drawing that are at most this apart are joined. Part unit.
inline constexpr double drawingJoint = 1e-3;
/// Chords of curved boundaries are this near to the curve where CHORD does not say. mm.
inline constexpr double boundaryChord = 0.05;

}  // namespace arelem::tolerance
