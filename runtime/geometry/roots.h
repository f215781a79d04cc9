#pragma once

namespace arelem::geometry {

struct QuadraticRoots {
  int count = 0;
  double first = 0.0, second = 0.0;  ///< ascending
};

/// Real roots of a t^2 + 2 b t + c = 0. The sign of the discriminant b^2 - a c is exact, so a
/// double root is reported as one and never lost to rounding of the products. a = 0: the linear
/// root. No equation: none.
[[nodiscard]] QuadraticRoots solveQuadratic(double a, double b, double c);

}  // namespace arelem::geometry
