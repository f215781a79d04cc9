#pragma once

/// Tolerances of roadway stencils. Other fields: tolerance.h.
namespace arelem::tolerance {

/// A run whose cells all cost less than this (the square of the square of their lean) is even
/// already: a lean of 0.01, a film within 1 / 20000. Dimensionless.
inline constexpr double evenLean = 1e-16;
/// What an uneven division costs against a lean. Dimensionless.
inline constexpr double unevenDivision = 1e-4;
/// An order of runs is better when it shortens the travel by more than this, relative.
inline constexpr double shorterTravel = 1e-12;
/// A speed may be above the gun's largest by this, relative.
inline constexpr double gunSpeed = 1e-9;
/// Speeds that differ by at most this are the same when the fastest job is looked for. Relative.
inline constexpr double fastestJob = 1e-4;
/// A place of a film map may lie this far outside of a patch. In sides of the patch.
inline constexpr double patchEdge = 1e-9;
/// The smallest extent of a film map. mm.
inline constexpr double mapExtent = 1e-9;
/// A ground that leans less is level. Degrees.
inline constexpr double levelGround = 1e-6;

/// The lowest height of a nozzle over the ground. mm.
inline constexpr double nozzleHeight = 1e-3;
/// The smallest area of a cell. In squares of its width.
inline constexpr double cellArea = 1e-9;
/// The ends of two strokes that are joined may lie this far apart: a cell joins them. In widths.
inline constexpr double joinedLines = 1.001;
/// Two fan lines that lie this close are one. In widths.
inline constexpr double sameLine = 1e-6;

/// A depth of three steps takes three passes, however its division is rounded. Relative to a step.
inline constexpr double wholePasses = 1e-9;
/// A frame whose z direction differs less is upright: what the rounding of a turn leaves.
/// Component of a unit vector.
inline constexpr double turnedAxis = 1e-12;
/// A figure below this is printed as 0. In the unit in which it is printed.
inline constexpr double printedNothing = 1e-9;

}  // namespace arelem::tolerance
