#pragma once

/// Tolerances of path splines, of their smoothing, and of the time law.
namespace arelem::tolerance {

/// A path whose directions before and after a place add up to at most this leads back on itself.
/// Dimensionless.
inline constexpr double cusp = 1e-6;
/// Smoothing ends when its largest move is at most this times the tolerance. Relative.
inline constexpr double smoothStillness = 1e-9;
/// Of the factor that brings a smoothed curve into its tube: rounding must not lift it out again.
/// Relative.
inline constexpr double smoothTubeRounding = 1e-12;
/// Weights of the curvature are at least this share of the largest near them: straight parts stay
/// straight. Dimensionless.
inline constexpr double smoothLeastWeight = 1e-3;
/// Derivatives by the parameter that are shorter than this count as this long. Part unit for each
/// unit of the parameter.
inline constexpr double smoothLeastSpeed = 1e-9;
/// Stiffness of a least squares fit against the terms of its points. Relative.
inline constexpr double splineFitStiffness = 1e-12;
/// A closest point is found when the parameter moves by at most this times its range. Relative.
inline constexpr double splineNoStep = 1e-12;
/// No point of a curve is nearer than the one found by more than this times the curve's size.
/// Relative.
inline constexpr double splineNearest = 1e-9;
/// Chords of a spline of a CL file, for its time. mm.
inline constexpr double timeSplineChord = 1e-3;
/// Speeds of the plan keep their limits within this. Relative.
inline constexpr double planSlack = 1e-10;
/// A bisection of the time law ends at this share of its range. Relative.
inline constexpr double transitionEnough = 1e-13;

}  // namespace arelem::tolerance
