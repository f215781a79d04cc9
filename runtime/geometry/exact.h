#pragma once

/// Signs that are exact for the given doubles: where a sign decides a branch, rounding must not.
/// Each returns -1, 0 or +1. All arguments must be finite. Evaluated in doubles first; only where
/// the error bound reaches the value, in rational numbers.
namespace arelem::geometry {

/// Sign of b^2 - a c.
[[nodiscard]] int discriminantSign(double a, double b, double c);
/// Sign of a x + b y - d: +1 on the side that the normal (a, b) of the line points to.
[[nodiscard]] int sideOfLine(double a, double b, double d, double x, double y);
/// Whether a, b, c turn to the left (+1), to the right (-1) or lie on one line (0).
[[nodiscard]] int turn(double ax, double ay, double bx, double by, double cx, double cy);

}  // namespace arelem::geometry
