#pragma once
#include <array>
#include <vector>

#include "runtime/stencil/edge.h"

namespace arelem::stencil {

/// The mathematics of one fan line and of the cell between two of them. Lengths in one unit
/// throughout, angles in degrees. Source: Blank 2.4 and 2.5, with the corrections named at each.

/// Where the fan of the gun lies on the ground: from one edge of a stroke to the other.
struct Line {
  Vec2 first = Vec2::Zero();
  Vec2 second = Vec2::Zero();
};
[[nodiscard]] Vec2 middleOf(const Line& line);
[[nodiscard]] double widthOf(const Line& line);
/// Direction from the first to the second edge, counterclockwise from x, above -180 to 180 (2.4).
[[nodiscard]] double yawOf(const Line& line);

/// Height of the nozzle over the middle of a line of this width for a fan of full angle `fan`
/// (2.5).
[[nodiscard]] double heightFor(double width, double fan);

/// How the two halves of a cell, on the first and on the second edge's side of the line through the
/// middles, share its area: 100 A_i / (A_i + A_j), the first half's share in percent (2.7).
[[nodiscard]] double areaShare(const Line& from, const Line& to);
/// The same for a division at the share `s` of both lines from the first edge.
[[nodiscard]] double areaShare(const Line& from, const Line& to, double s);

/// Where a line parallel to the sides b1 and b2 of a trapezoid halves its area: share of the height
/// from b1 (2.11). No division by zero for equal sides, unlike the printed form.
[[nodiscard]] double trapezoidShare(double b1, double b2);

/// Where the division of both lines at one share halves the cell's area: the share from the first
/// edge (2.13 to 2.20; 2.17 lacks a factor 1/2, 2.19 and 2.20 fail for upright sides).
[[nodiscard]] double quadrilateralShare(const Line& from, const Line& to);

/// Tilt of the gun for which the middle of the fan falls at `share` of the line from the first
/// edge: tan(tilt) = (2 share - 1) / tan(fan / 2). Positive: the gun stands towards the second
/// edge. (2.10) as printed gives the fan angle for equal halves; its numerator must be
/// x_j - x_i cos.
[[nodiscard]] double tiltFor(double share, double fan);
/// The share of the line at which the middle of a tilted fan falls: the inverse of `tiltFor`.
[[nodiscard]] double shareOf(double tilt, double fan);

/// The place of a tilted gun whose fan still covers the line from edge to edge.
struct Tilted {
  double shift = 0.0;   ///< from the middle along the line towards the second edge
  double height = 0.0;  ///< of the nozzle
};
/// shift = (w/2) sin 2tilt / sin fan, height = w cos(fan/2 + tilt) cos(fan/2 - tilt) / sin fan:
/// equal to (2.21) to (2.24).
[[nodiscard]] Tilted placeTilted(double width, double fan, double tilt);

}  // namespace arelem::stencil
