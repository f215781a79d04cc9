#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "runtime/geometry/kinds/tabulated.h"

/// A piece of the curve of a tabulated cylinder, in its local frame.
namespace arelem::surface::tabulated {

using Piece = TabulatedCylinder::Piece;

/// Directions of two neighbors that differ by less than this meet smoothly. Radians.
inline constexpr double smoothJoint = 1e-7;

inline double height(const Piece& p, double x) {
  return ((p.a * x + p.b) * x + p.c) * x;
}
inline double slope(const Piece& p, double x) {
  return (3.0 * p.a * x + 2.0 * p.b) * x + p.c;
}
inline double second(const Piece& p, double x) {
  return 6.0 * p.a * x + 2.0 * p.b;
}

struct Local {
  double x, y;
};

inline Local toLocal(const Piece& p, double u, double v) {
  const double du = u - p.u;
  const double dv = v - p.v;
  return {du * p.dirU + dv * p.dirV, dv * p.dirU - du * p.dirV};
}

inline double low(const Piece& p) {
  return p.openStart ? -std::numeric_limits<double>::infinity() : 0.0;
}
inline double high(const Piece& p) {
  return p.openEnd ? std::numeric_limits<double>::infinity() : p.length;
}

inline double squaredTo(const Piece& p, const Local& q, double x) {
  const double dx = x - q.x;
  const double dy = height(p, x) - q.y;
  return dx * dx + dy * dy;
}

/// Lower bound of the squared distance to a piece, from its bounding box in the local frame.
inline double boxBound(const Piece& p, const Local& q) {
  const double dx = std::max({low(p) - q.x, 0.0, q.x - high(p)});
  const double dy = std::max({p.lowY - q.y, 0.0, q.y - p.highY});
  return dx * dx + dy * dy;
}

/// The same for a part of a piece, which is within its sag of the box of its chord.
inline double partBound(const Piece& p, const Local& q, double from, double to) {
  const double width = to - from;
  const double sag =
      0.125 * width * width * std::max(std::abs(second(p, from)), std::abs(second(p, to)));
  const double y0 = height(p, from);
  const double y1 = height(p, to);
  const double dx = std::max({from - q.x, 0.0, q.x - to});
  const double dy = std::max({std::min(y0, y1) - sag - q.y, 0.0, q.y - std::max(y0, y1) - sag});
  return dx * dx + dy * dy;
}

}  // namespace arelem::surface::tabulated
