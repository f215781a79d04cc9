#pragma once

/// Tolerances of spray painting, films and regions, as ir/space/tolerance.h holds the others.
namespace arelem::tolerance {

/// A step of a search this small, or 0, has one value. Unit of the range.
inline constexpr double searchStep = 1e-300;
/// The place of a film's largest departure is known to this part of a smooth piece. Radians of its
/// half circle.
inline constexpr double filmPeak = 1e-6;
/// The outermost sections of a surface lie this part of its extent inside, where a plane still
/// meets it. Dimensionless.
inline constexpr double sectionMargin = 1e-6;
/// The first and the last section run along an edge where they lie this near to it: more than the
/// margin. Part of the parameter's range.
inline constexpr double edgeOfSection = 1e-4;
/// A surface that bends less is flat. 1/mm.
inline constexpr double flat = 1e-7;
/// The smallest radius of a surface is looked for as near to its ends as this part of its extent:
/// at the ends themselves a pole or a vertex has none. Dimensionless.
inline constexpr double rimMargin = 1e-3;

/// Steps of the differences that give normals and curvatures, relative to the range of a
/// parameter: the third and fourth root of the rounding, where the errors of the difference and of
/// the rounding are alike.
inline constexpr double normalStep = 6e-6;
inline constexpr double curvatureStep = 2e-4;
/// A line on a surface that is shorter is a dot: a pole, a vertex. Of the footprint's half width.
inline constexpr double shortestLine = 1e-2;
/// A way whose end lies this near to a wall touches it. mm.
inline constexpr double wallTouch = 1e-6;
/// A nozzle that is nearer to the work than this part of the stand-off has a wall beside it.
inline constexpr double wallClear = 0.25;
/// Walls are looked for from this part of the stand-off above the work on: below, the work itself
/// is near.
inline constexpr double wallLift = 0.05;
/// Of the stand-off, what a gun that is switched off keeps off the work where CLEARP does not say.
inline constexpr double wayClear = 0.5;
/// A way of the gun is proven clear in steps of at least this part of its clearance, which it keeps
/// to spare.
inline constexpr double wayStep = 0.05;
/// A surface that leans more against the planes of sections, its normal nearer to theirs, is not
/// followed by closer planes. Sine.
inline constexpr double leastLean = 0.1;
/// Arcs are drawn with at least this angle between corners. Radians.
inline constexpr double arcStep = 1e-9;
/// A row of film cells that runs along a pass, or square to it, but for this, does so. Sine.
inline constexpr double filmRow = 1e-12;
/// Corners of a region lie nearer: areas and planes of what lies farther are rounding. Part unit.
inline constexpr double farthestCorner = 1e9;
/// The smallest extent of a picture. mm.
inline constexpr double pictureExtent = 1e-9;
/// A tool axis that leans less has no direction to which it leans. Sine.
inline constexpr double uprightAxis = 1e-9;

}  // namespace arelem::tolerance
