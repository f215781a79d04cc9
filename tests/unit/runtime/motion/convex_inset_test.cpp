#include "runtime/motion/convex_inset.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::motion {
namespace {

const std::vector<Vec2> rectangle{{0, 0}, {10, 0}, {10, 6}, {0, 6}};

TEST(ConvexInset, RectangleKeepsItsFirstVertex) {
  const ConvexInset inset(rectangle);
  EXPECT_NEAR(inset.depth(), 3.0, 1e-9);
  const auto at = inset.at(2.0);
  ASSERT_TRUE(at);
  ASSERT_EQ(at->size(), 4u);
  EXPECT_LT((at->front() - Vec2(2, 2)).norm(), 1e-14);
  EXPECT_LT((at->at(2) - Vec2(8, 4)).norm(), 1e-14);
  EXPECT_FALSE(inset.at(3.1));
}

TEST(ConvexInset, ShortSidesVanish) {
  // A square of 4 with one corner cut off at 45 degrees: the cut, sqrt(2) long, shrinks by
  // 2 tan(22.5) a unit and is gone at sqrt(2) / (2 tan 22.5) = 1.7071.
  const std::vector<Vec2> cut{{1, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}};
  const ConvexInset inset(cut);
  ASSERT_EQ(inset.at(1.7)->size(), 5u);
  const auto square = inset.at(1.8);
  ASSERT_EQ(square->size(), 4u);
  // The vertex where the cut was is the image of the first one.
  EXPECT_LT((square->front() - Vec2(1.8, 1.8)).norm(), 1e-12);
  EXPECT_NEAR(inset.depth(), 2.0, 1e-9);
}

TEST(ConvexInset, DepthOfATriangleIsItsInradius) {
  const std::vector<Vec2> triangle{{0, 0}, {4, 0}, {0, 3}};
  EXPECT_NEAR(ConvexInset(triangle).depth(), 1.0, 1e-9);
}

TEST(ConvexInset, DistanceIsZeroInsideOnly) {
  EXPECT_EQ(distanceTo(rectangle, Vec2(3, 3)), 0.0);
  EXPECT_NEAR(distanceTo(rectangle, Vec2(13, 10)), 5.0, 1e-14);
  EXPECT_NEAR(distanceTo(rectangle, Vec2(5, -2)), 2.0, 1e-14);
}

}  // namespace
}  // namespace arelem::motion
