#pragma once
#include <array>
#include <vector>

#include "runtime/spray/outline.h"

namespace arelem::spray {

/// The footprint of a gun: an ellipse of half axis `along` in the direction of the passes (0 for
/// the line of a flat fan) and `across`.
struct Footprint {
  double along = 0.0;   ///< a, mm
  double across = 0.0;  ///< b, mm
};

/// Distance from the center of the footprint to its tangent of unit normal n: the offset of an edge
/// with that normal. d = sqrt(a^2 nx^2 + b^2 ny^2), which is Bartlett's (3.20) to (3.22); the
/// listing of intersect1 has a for a^2.
[[nodiscard]] double support(const Footprint& footprint, const Vec2& normal);
/// Where the footprint touches that tangent, from its center.
[[nodiscard]] Vec2 touch(const Footprint& footprint, const Vec2& normal);

/// A closed interval of a pass.
struct Interval {
  double from = 0.0;
  double to = 0.0;
};

/// Where the gun sprays: all places of its center from which the footprint meets the outline, with
/// the corners of neighboring offset lines mitred as the source does (3.3.3). Unlike an offset
/// curve it stays right where offset edges cross: in narrow slots, small holes, sharp corners.
class SprayedArea {
 public:
  /// `sharpest` limits mitres: a corner reaches at most this times the footprint.
  SprayedArea(const Outline& outline, const Footprint& footprint, double sharpest);

  /// The intervals of the pass at this height, in order, apart from each other.
  [[nodiscard]] std::vector<Interval> at(double height) const;

  /// The strip that an edge adds beside the outline.
  struct Band {
    std::array<Vec2, 4> corners;
    double low = 0.0, high = 0.0;
  };
  [[nodiscard]] const std::vector<Band>& bands() const { return bands_; }

 private:
  struct Edge {
    Vec2 from, to;
  };
  void addLoop(const Loop& loop, const Footprint& footprint, double sharpest);

  std::vector<Band> bands_;  // by rising lower end
  std::vector<Edge> edges_;  // of the outline, by rising lower end
  double tallestBand_ = 0.0;
  double tallestEdge_ = 0.0;
};

}  // namespace arelem::spray
