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

/// How the area of a cell lies across it: between the shares s and s + ds of its lines from the
/// first edge lies the part (1 + lean (2 s - 1)) ds of it. Above 0: the second edge is the longer
/// one; beyond +-1 the cell is folded.
struct Balance {
  double area = 0.0;  ///< positive
  double lean = 0.0;
};
[[nodiscard]] Balance balanceOf(const Line& from, const Line& to);
/// Area of a cell, positive.
[[nodiscard]] double areaOf(const Line& from, const Line& to);

/// How a tilted gun divides its paint along a line. The nozzle's flow is even over its own width
/// when it stands square: even in the tangent of the angle to the fan's middle (Blank 2.5). A
/// tilted gun throws that line centrally upon the ground, ends upon ends; such a map of 0..1 upon
/// itself has one number m, and the middle of the fan fixes it: m = share / (1 - share).
[[nodiscard]] double steepnessOf(double tilt, double fan);
/// Share of the paint that lands between the first edge and the share `s` of a line:
/// s / (s + m (1 - s)).
[[nodiscard]] double paintUpTo(double s, double fan, double tilt);
/// Paint per share of the line there, the derivative: m / (s + m (1 - s))^2.
[[nodiscard]] double paintAt(double s, double steepness);

inline constexpr int stripsOfACell = 10;

/// Film over the mean film of a cell, strip by strip from the first edge.
[[nodiscard]] std::array<double, stripsOfACell> filmOf(double lean, double steepness);
[[nodiscard]] Spread spreadOf(double lean, double steepness);
[[nodiscard]] Spread spreadOf(const Line& from, const Line& to, double fan, double tilt);

}  // namespace arelem::stencil
