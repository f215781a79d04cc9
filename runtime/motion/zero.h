#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "ir/space/tolerance.h"

namespace arelem::motion {

/// A zero of f in [low, high], where the signs differ: regula falsi with the Illinois rule, and a
/// bisection now and then. Where the signs do not differ, as what brackets the zero may only
/// approximate f, it is looked for beside: that is the nearest one, and of two as near the one
/// ahead. f returns an optional number; none ends the search.
template <class F>
std::optional<double> zeroBetween(F f, double low, double high) {
  constexpr int rootLimit = 200;
  // Slowly, so that two zeros that are next to each other are not passed at once.
  constexpr int widenLimit = 48;
  constexpr double widening = 1.1;
  constexpr int bisectEvery = 8;
  constexpr double rounding = 1e-15;
  auto fl = f(low);
  auto fh = f(high);
  double grow = std::max(high - low, tolerance::coincidence);
  for (int i = 0; i < widenLimit && fl && fh && (*fl > 0.0) == (*fh > 0.0); ++i, grow *= widening) {
    const double below = low - grow;
    const double above = high + grow;
    const auto fBelow = f(below);
    const auto fAbove = f(above);
    if (!fBelow || !fAbove) {
      return std::nullopt;
    }
    const bool isAbove = (*fAbove > 0.0) != (*fh > 0.0);
    const bool isBelow = !isAbove && (*fBelow > 0.0) != (*fl > 0.0);
    // Of the whole range the search might take another zero.
    const double from = isAbove ? high : below;
    const auto fFrom = isAbove ? fh : fBelow;
    high = isBelow ? low : above;
    fh = isBelow ? fl : fAbove;
    low = from;
    fl = fFrom;
  }
  if (!fl || !fh || (*fl > 0.0) == (*fh > 0.0)) {
    return std::nullopt;
  }
  double a = low, b = high, fa = *fl, fb = *fh;
  for (int i = 1; i <= rootLimit && fa != fb; ++i) {
    const double middle = i % bisectEvery == 0 ? 0.5 * (a + b) : b - fb * (b - a) / (fb - fa);
    const auto fm = f(middle);
    if (!fm) {
      return std::nullopt;
    }
    if (*fm == 0.0 || std::abs(b - a) <= rounding * (1.0 + std::abs(middle))) {
      return middle;
    }
    if ((*fm > 0.0) != (fb > 0.0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = middle;
    fb = *fm;
  }
  return b;
}

}  // namespace arelem::motion
