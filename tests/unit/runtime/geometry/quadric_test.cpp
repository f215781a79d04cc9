#include "runtime/geometry/kinds/quadric.h"

#include <cmath>

#include <gtest/gtest.h>

/// Places next to where a quadric is as near on several sides.
namespace arelem::surface {
namespace {

Quadric ofSemiAxes(const Vec3& semiAxes) {
  const Vec3 roots = semiAxes.cwiseProduct(semiAxes).cwiseInverse();
  return {Eigen::Matrix3d(roots.asDiagonal()), Vec3::Zero(), -1.0};
}

TEST(Quadric, NextToTheAxisOfARoundOneTheFootIsOnThatSide) {
  const Quadric round = ofSemiAxes({2.0, 2.0, 9.0});
  for (const double off : {0.05, 1e-3, 1e-8, 1e-12}) {
    for (const Vec3& out : {Vec3::UnitX().eval(), Vec3::UnitY().eval(), Vec3(0.6, -0.8, 0.0)}) {
      Quadric::Hint hint;
      const Foot foot = round.foot(off * out, hint);
      EXPECT_NEAR(foot.distance, off - 2.0, 1e-15) << off;
      EXPECT_NEAR(foot.normal.dot(out), 1.0, off > 1e-10 ? 1e-10 : 1e-6) << off;
    }
  }
}

TEST(Quadric, BesideItsFlatSidesMiddleTheFootIsOutwards) {
  // On the plane z = 0 the feet of x leave it where x < (a^2 - c^2) / a: x' = x a^2 / (a^2 - c^2).
  const double a = 5.0, c = 1.0;
  const Quadric flat = ofSemiAxes({a, 4.0, c});
  for (const double x : {0.0, 1.0, 3.0, 4.5}) {
    const double there = x * a * a / (a * a - c * c);
    const double high = c * std::sqrt(1.0 - there * there / (a * a));
    for (const double z : {0.0, 1e-14, -1e-11, 1e-7}) {
      Quadric::Hint hint;
      const double distance = flat.foot({x, 0.0, z}, hint).distance;
      EXPECT_NEAR(distance, -std::hypot(there - x, high), 1e-12 + std::abs(z)) << x << ' ' << z;
    }
  }
}

TEST(Quadric, TurnsWithinNumbersWhereItIsAsNearOnTwoSides) {
  const Quadric flat = ofSemiAxes({5.0, 4.0, 1.0});
  Quadric::Hint hint;
  const Vec3 middle(1.0, 0.5, 0.0);
  const Foot foot = flat.foot(middle, hint);
  EXPECT_TRUE(flat.turn(middle, foot, Vec3::UnitX(), hint).allFinite());
  EXPECT_TRUE(flat.turn(middle, foot, Vec3::UnitZ(), hint).allFinite());
}

}  // namespace
}  // namespace arelem::surface
