#pragma once
#include "runtime/stencil/line.h"

namespace arelem::stencil {

/// How evenly the paint of a cell lies: film over mean film of the cell in strips along it.
struct Spread {
  double least = 1.0;
  double most = 1.0;
  /// The largest departure from the mean.
  [[nodiscard]] double worst() const;
  void add(const Spread& other);
};

/// Share of the paint that lands between the first edge and the share `s` of a line, for a gun
/// tilted by `tilt`. The nozzle's flow is even over its own width when it stands square: even in
/// the tangent of the angle to the fan's middle. Source of the assumption: Blank 2.5.
[[nodiscard]] double paintUpTo(double s, double fan, double tilt);

inline constexpr int stripsOfACell = 10;

/// Film over the mean film of a cell, strip by strip from the first edge.
[[nodiscard]] std::array<double, stripsOfACell> filmOf(const Line& from,
                                                       const Line& to,
                                                       double fan,
                                                       double tilt);
[[nodiscard]] Spread spreadOf(const Line& from, const Line& to, double fan, double tilt);

/// Area of a cell, positive.
[[nodiscard]] double areaOf(const Line& from, const Line& to);

/// The tilt within +-most whose film departs least from its mean; degrees.
[[nodiscard]] double bestTilt(const Line& from, const Line& to, double fan, double most);

/// Moves the points of the second edge along it so that the worst film of all cells, each with its
/// best tilt, becomes as even as it can. The first edge keeps its points. Deterministic.
[[nodiscard]] std::vector<Line> bestDivision(const std::vector<Line>& lines,
                                             const Measured& second,
                                             double fan,
                                             double most);

}  // namespace arelem::stencil
