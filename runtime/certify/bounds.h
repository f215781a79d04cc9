#pragma once
#include <limits>

/// Bounds of a function between two places where its value and slope are known: the arithmetic of
/// the certificate. docs/manual/verify.md derives the formulas.
namespace arelem::certify {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// What is known at one place. `low` <= value <= `high`; the slope belongs to a function that
/// touches the value there (a contact kept on the cutter, or a plane that supports the surface).
struct Known {
  double low = 0.0, high = 0.0;
  double slope = 0.0;  ///< per unit of s
};

/// What is known about the second derivative by s. `least` bounds it from below (the function plus
/// a parabola of -least is convex), `most` from above, in the sense of kinks too.
struct Curving {
  double least = -unbounded;
  double most = unbounded;
};

struct Range {
  double low = -unbounded, high = unbounded;
};

/// Range of the function over the interval of length `h` between `a` and `b`, as narrow as chords,
/// tangents and the greatest rate of change allow.
[[nodiscard]] Range between(
    const Known& a, const Known& b, double h, const Curving& curving, double rate);

}  // namespace arelem::certify
