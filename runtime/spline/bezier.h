#pragma once
#include <array>
#include <utility>

#include "ir/space/vector.h"

namespace arelem::spline {

/// One cubic piece of a path spline over the parameters `begin` to `end`.
struct Bezier {
  std::array<Vec3, 4> control;
  double begin = 0.0;
  double end = 1.0;

  [[nodiscard]] Vec3 at(double t) const;
  /// |p' x p''| / |p'|^3; 0 where p' is null.
  [[nodiscard]] double curvature(double t) const;
  /// Both halves at the middle parameter (de Casteljau).
  [[nodiscard]] std::pair<Bezier, Bezier> halves() const;
  /// The part between two parameters (de Casteljau).
  [[nodiscard]] Bezier part(double from, double to) const;
  /// No point of the piece is farther than this from its chord: the larger distance of the inner
  /// control points from it (convex hull).
  [[nodiscard]] double chordBound() const;
  /// No point of the piece is farther from the origin than this.
  [[nodiscard]] double hullRadius() const;
  /// Length to about 1e-9 of it for pieces that turn less than a right angle (five-point Gauss).
  [[nodiscard]] double length() const;
};

/// Curvature at the start of a Bezier curve of degree 3: (2/3) h / a^2 with a = |P1 - P0| and h the
/// distance of P2 from the line P0 P1. Source: Naseath, eq. 3-6 with its last term corrected.
/// In the xy plane the sign is + for a left turn.
[[nodiscard]] double startCurvatureInPlane(const std::array<Vec3, 4>& control);

/// No point of the piece is farther from the origin than this: the hulls of its parts after so many
/// halvings.
[[nodiscard]] double hullOfHalves(const Bezier& piece, int halvings);

/// Distance of p from the segment from a to b.
[[nodiscard]] double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b);

}  // namespace arelem::spline
