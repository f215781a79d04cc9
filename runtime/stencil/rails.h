#pragma once
#include <vector>

#include "runtime/stencil/alphabet.h"

namespace arelem::stencil {

/// One edge of a run, through all strokes that it is made of, with the places of the fan lines on
/// it. Places are lengths along it; between its points it is straight.
class Rail {
 public:
  /// Goes on along these points. The stroke's lines stand at `shares` of their length; the first of
  /// them is left out where it is the line that the rail ends with.
  void extend(const std::vector<Vec2>& points,
              const std::vector<double>& shares,
              bool withoutFirst);

  [[nodiscard]] double length() const { return along_.back(); }
  [[nodiscard]] Vec2 at(double place) const;
  [[nodiscard]] const std::vector<double>& places() const { return places_; }
  /// Whether a line stands at a corner of the edge: there it must stay, or the corner is cut off.
  [[nodiscard]] bool isCorner(std::size_t line) const;

 private:
  void add(const Vec2& point);

  std::vector<Vec2> points_;
  std::vector<double> along_;  // length up to each point
  std::vector<double> places_;
};

/// The edges of a stroke at its place in a symbol of this width, as points that lie within 1e-4
/// grid units of the curves; of a straight stroke those of its lines.
struct Edges {
  std::vector<Vec2> first;
  std::vector<Vec2> second;
};
[[nodiscard]] Edges edgesOf(const Stroke& stroke, double symbolWidth, double gridHeight);

/// The lines of a run with their ends moved along the rails so that its cells lean as little as
/// they can: the sum of the eighth powers of their leans is made small, for the film of the worst
/// cell follows its lean, and with it how much the cells' lengths change, so that small leans,
/// which do no harm, leave neighbors alike. First and last line and corners stay, and no line moves
/// where the straight side of a cell would leave its edge by more than `bow` and more than it did.
/// Deterministic.
[[nodiscard]] std::vector<Line> evenlyLeaning(const Rail& first, const Rail& second, double bow);

}  // namespace arelem::stencil
