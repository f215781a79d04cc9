#include "runtime/tool/bracket.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::tool {
namespace {

TEST(Bracket, FindsWhereTwoBranchesCrossByTheirTangents) {
  // The greater of two parabolas, which cross where x^2 + 3x = 1, at slopes -3 + 2x and 4x.
  const double crossing = 0.5 * (std::sqrt(13.0) - 3.0);
  Bracket bracket;
  double x = 0.0;
  int looks = 0;
  for (bool isFound = false; !isFound && looks < 60; ++looks) {
    const double left = 1.0 - 3.0 * x + x * x;
    const double right = 2.0 * x * x;
    const bool isLeft = left > right;
    isFound = isLeft ? bracket.note(x, left, -3.0 + 2.0 * x, Vec3(-1.0, 1.0, 0.0))
                     : bracket.note(x, right, 4.0 * x, Vec3(1.0, 1.0, 0.0));
    if (!isFound) {
      x = bracket.keep(isLeft ? x + 1.0 : x - 0.9, looks);
    }
  }
  EXPECT_NEAR(x, crossing, 1e-13);
  EXPECT_LE(looks, 20);  // halves would take 45
  const double falls = 3.0 - 2.0 * crossing, rises = 4.0 * crossing;
  EXPECT_NEAR(bracket.meanNormal().x(), (falls - rises) / (falls + rises), 1e-6);
  EXPECT_NEAR(bracket.meanNormal().y(), 1.0, 1e-12);
}

TEST(Bracket, LeavesSmoothValuesToNewton) {
  // x^4 - x: Newton from 1 ends where 4 x^3 = 1.
  Bracket bracket;
  double x = 1.0;
  for (int i = 0; i < 30; ++i) {
    const double slope = 4.0 * x * x * x - 1.0;
    EXPECT_FALSE(bracket.note(x, x * x * x * x - x, slope, Vec3::UnitX()));
    x = bracket.keep(x - slope / (12.0 * x * x), i);
  }
  EXPECT_NEAR(x, std::cbrt(0.25), 1e-14);
}

}  // namespace
}  // namespace arelem::tool
