#include "runtime/geometry/roots.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/geometry/angle.h"
#include "runtime/geometry/directed_distance.h"
#include "runtime/geometry/exact.h"
#include "runtime/geometry/polynomial.h"

namespace arelem::geometry {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

TEST(Exact, SignsBelowRounding) {
  // 0.1 as a double is 1 + 2^-54... times a tenth: its square is not the product of its neighbors.
  const double x = 0.1, above = std::nextafter(0.1, 1.0), below = std::nextafter(0.1, 0.0);
  EXPECT_EQ(discriminantSign(x, x, x), 0);
  EXPECT_EQ(discriminantSign(above, x, below), 1);  // x^2 > (x + e)(x - e)
  EXPECT_EQ(discriminantSign(above, x, x), -1);
  // The line through (0, 0) and (1, 1) extended: a place one unit in the last place off it.
  EXPECT_EQ(sideOfLine(1.0, -1.0, 0.0, 1e16, 1e16), 0);
  EXPECT_EQ(sideOfLine(1.0, -1.0, 0.0, std::nextafter(1e16, 2e16), 1e16), 1);
  EXPECT_EQ(sideOfLine(0.1, 0.2, 0.3, 1.0, 1.0), 1);  // 0.1 + 0.2 > 0.3 as doubles, exactly
}

TEST(Quadratic, DoubleRootsAreNotLost) {
  EXPECT_EQ(solveQuadratic(1.0, -0.1, 0.1 * 0.1).count, discriminantSign(1.0, -0.1, 0.1 * 0.1) + 1);
  const QuadraticRoots touching = solveQuadratic(2.0, -6.0, 18.0);
  ASSERT_EQ(touching.count, 1);
  EXPECT_EQ(touching.first, 3.0);
}

TEST(Quadratic, SmallRootBesideALargeOne) {
  const QuadraticRoots roots = solveQuadratic(1.0, -5e7, 1.0);  // product of the roots 1
  ASSERT_EQ(roots.count, 2);
  EXPECT_NEAR(roots.first * roots.second, 1.0, 1e-15);
}

TEST(Polynomial, FindsAllRootsOnce) {
  // (t - 1)(t - 2)(t - 4) = t^3 - 7 t^2 + 14 t - 8
  const double cubic[] = {-8.0, 14.0, -7.0, 1.0};
  EXPECT_THAT(rootsWithin(cubic, 0.0, 5.0),
              ElementsAre(DoubleNear(1, 1e-14), DoubleNear(2, 1e-14), DoubleNear(4, 1e-14)));
  EXPECT_THAT(rootsWithin(cubic, 1.5, 3.0), ElementsAre(DoubleNear(2, 1e-14)));
  EXPECT_THAT(rootsWithin(cubic, 4.0, 9.0), ElementsAre(4.0));
  // (t - 3)^2 touches zero.
  const double square[] = {9.0, -6.0, 1.0, 0.0};
  EXPECT_THAT(rootsWithin(square, 0.0, 5.0), ElementsAre(3.0));
  const double none[] = {1.0, 0.0, 1.0};
  EXPECT_TRUE(rootsWithin(none, -5.0, 5.0).empty());
}

TEST(Angle, RationalValuesAreExact) {
  EXPECT_EQ(sinCosDegrees(-30.0).sin, -0.5);
  EXPECT_EQ(sinCosDegrees(420.0).cos, 0.5);
  EXPECT_EQ(sinCosDegrees(1e9 * 360.0 + 180.0).cos, -1.0);
  EXPECT_EQ(sinCosDegrees(-90.0).cos, 0.0);
}

TEST(DirectedDistance, TorusAlongItsPlaneAndThroughItsHole) {
  const Torus torus{Vec3(0, 0, 1), Vec3::UnitZ(), 5.0, 1.0};
  const auto along = [&](double x, Crossing which) {
    return directedDistance(torus, Vec3(x, 0, 1), Vec3::UnitX(), which);
  };
  EXPECT_NEAR(*along(-10, Crossing::ahead), 4.0, 1e-12);
  EXPECT_NEAR(*along(-5, Crossing::ahead), 1.0, 1e-12);
  EXPECT_NEAR(*along(0, Crossing::ahead), 4.0, 1e-12);
  EXPECT_NEAR(*along(7, Crossing::nearest), -1.0, 1e-12);
  EXPECT_FALSE(along(7, Crossing::ahead));
  EXPECT_FALSE(directedDistance(torus, Vec3::Zero(), Vec3::UnitZ(), Crossing::nearest));
  EXPECT_NEAR((*unitNormal(torus, Vec3(5, 0, 2)) - Vec3::UnitZ()).norm(), 0.0, 1e-15);
  EXPECT_NEAR((*unitNormal(torus, Vec3(4, 0, 1)) + Vec3::UnitX()).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace arelem::geometry
