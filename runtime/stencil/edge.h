#pragma once
#include <array>
#include <variant>
#include <vector>

#include "runtime/geometry/shapes.h"

namespace arelem::stencil {

using geometry::Vec2;

/// A straight piece of an edge.
struct LinePiece {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::Zero();
};
/// A cardinal spline of tension 1 from the second to the third of its four control points.
/// Source: Blank (2.1) to (2.3); the third row of the printed matrix lost an `a`, the listing has
/// it.
struct SplinePiece {
  std::array<Vec2, 4> control{Vec2::Zero(), Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
};
/// A quarter or other part of an ellipse whose axes lie along x and y; angles are parametric, in
/// degrees: center + (rx cos, ry sin).
struct ArcPiece {
  Vec2 center = Vec2::Zero();
  Vec2 radii = Vec2::Ones();
  double start = 0.0;
  double end = 90.0;
};
using Piece = std::variant<LinePiece, SplinePiece, ArcPiece>;

/// One side of a stroke: pieces end to end, in units of the alphabet's grid.
struct Edge {
  std::vector<Piece> pieces;
};

/// The point of a piece at 0 <= t <= 1.
[[nodiscard]] Vec2 pointOf(const Piece& piece, double t);
[[nodiscard]] Vec2 firstPoint(const Edge& edge);
[[nodiscard]] Vec2 lastPoint(const Edge& edge);

/// A curve measured along its length: points by their share of it.
class Measured {
 public:
  explicit Measured(const Edge& edge);
  [[nodiscard]] double length() const { return length_.back(); }
  /// The point at a share of the length, 0 to 1.
  [[nodiscard]] Vec2 at(double share) const;

 private:
  struct Sample {
    std::size_t piece = 0;
    double from = 0.0, to = 1.0;  // parameters of the interval that ends here
  };
  static constexpr int samplesOfACurve = 256;
  std::vector<Piece> pieces_;
  std::vector<Sample> samples_;
  std::vector<double> length_;  // up to the end of each interval
};

}  // namespace arelem::stencil
