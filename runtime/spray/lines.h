#pragma once

/// Lines of a pattern on a surface: how many and how far apart. Source: Sen 5.2, appendix C.
namespace arelem::spray {

struct LineCount {
  int intervals = 0;
  double step = 0.0;  ///< length between two lines
  [[nodiscard]] int lines() const { return intervals + 1; }
};

/// intervals = ceil(length / widest), step = length / intervals.
[[nodiscard]] LineCount lineCount(double length, double widest);

/// Speed of a gun that leaves a mean film with lines `step` apart: v = mu sigma / (delta step).
/// flow mm3/s, film and step mm; result mm/s. Sen's (3) has step = 2 r, his (4) step = r.
[[nodiscard]] double speedFor(double flow, double efficiency, double film, double step);

/// Film in the middle of a spot that a gun at rest leaves in `seconds`, (1): delta =
/// mu sigma t / (pi r^2); mm.
[[nodiscard]] double spotFilm(double flow, double efficiency, double seconds, double radius);

}  // namespace arelem::spray
