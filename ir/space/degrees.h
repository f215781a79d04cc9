#pragma once

/// Trigonometry in degrees, the unit of every angle of the language.
namespace arelem {

struct SineCosine {
  double sine = 0.0;
  double cosine = 1.0;
};

/// Sine and cosine of a finite angle. Exact (0, 1/2, 1 and their negatives) wherever the result is
/// such a number, and reduced in degrees first, so that large angles lose nothing.
[[nodiscard]] SineCosine sineCosine(double degrees);

[[nodiscard]] double radians(double degrees);
[[nodiscard]] double degrees(double radians);

}  // namespace arelem
