#pragma once

namespace arelem::geometry {

/// Looks at f by golden sections of [low, high] around where it is least, as long as `worth` says
/// of the least value in sight and the width that it is for something. The middle of what is left.
template <class F, class Worth>
double narrowLeast(const F& f, double low, double high, const Worth& worth) {
  constexpr double golden = 0.6180339887498949;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double atLeft = f(left), atRight = f(right);
  while (left < right && worth(atLeft <= atRight ? atLeft : atRight, high - low)) {
    if (atLeft <= atRight) {
      high = right;
      right = left;
      atRight = atLeft;
      left = high - golden * (high - low);
      atLeft = f(left);
    } else {
      low = left;
      left = right;
      atLeft = atRight;
      right = low + golden * (high - low);
      atRight = f(right);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace arelem::geometry
