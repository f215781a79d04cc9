#pragma once
#include <vector>

#include "runtime/smooth/smooth.h"

namespace arelem::smooth {

/// How the tube is solved: rounds of so many turns, with weights of this exponent (0 is least
/// squares, larger ones approach the least maximum), while the bounds pull more and more.
struct Schedule {
  double exponent;
  int rounds;
  int turns;
};

/// Displacements that lead out of hairpins, at most `radius` long: what comes into a sharp turn
/// goes to one side, what leaves it to the other.
[[nodiscard]] std::vector<Vec3> opened(const spline::CubicSpline& curve, double radius);

/// Displacements of the control points of least curvature inside the tube round `original`, from
/// `start` on: the whole path at once, or windows along a long one.
[[nodiscard]] std::vector<Vec3> displaced(const spline::CubicSpline& original,
                                          const std::vector<Vec3>& start,
                                          const Schedule& schedule,
                                          const Options& options);

[[nodiscard]] spline::CubicSpline shifted(const spline::CubicSpline& curve,
                                          const std::vector<Vec3>& shift);

}  // namespace arelem::smooth
