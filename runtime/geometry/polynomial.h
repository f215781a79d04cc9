#pragma once
#include <span>
#include <vector>

namespace arelem::geometry {

/// Value of c0 + c1 t + c2 t^2 + ...
[[nodiscard]] double evaluate(std::span<const double> coefficients, double t);

/// Real roots within [low, high], ascending, each once: between the zeros of the derivative a
/// polynomial has at most one root, found by bisection with Newton steps. A place where the
/// polynomial touches zero within rounding of its terms counts as a root. Coefficients from the
/// lowest power; all zero: no roots.
[[nodiscard]] std::vector<double> rootsWithin(std::span<const double> coefficients,
                                              double low,
                                              double high);

}  // namespace arelem::geometry
