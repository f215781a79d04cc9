// Convex polygons whose sides move inwards: what POCKET is made of.
#include "runtime/motion/convex.h"

#include <cmath>

#include <gtest/gtest.h>

namespace arelem::motion {
namespace {

std::vector<Vec3> rectangle(double x, double y) {
  return {{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}};
}

TEST(Convex, RectangleShrinks) {
  const auto polygon = ConvexPolygon::make(rectangle(10, 4));
  ASSERT_TRUE(polygon);
  const auto inner = (*polygon).inset(1.0);
  ASSERT_TRUE(inner);
  ASSERT_EQ(inner->size(), 4U);
  EXPECT_NEAR(((*inner)[0] - Vec3(1, 1, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(((*inner)[2] - Vec3(9, 3, 0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE((*polygon).inset(2.1));
}

TEST(Convex, ShortSideVanishesAndTheFirstCornerStaysFirst) {
  // A corner cut off by a side of sqrt(2): its neighbors meet once they are far enough in.
  const auto polygon =
      ConvexPolygon::make({{1, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 1, 0}});
  ASSERT_TRUE(polygon);
  const auto inner = (*polygon).inset(4.0);
  ASSERT_TRUE(inner);
  ASSERT_EQ(inner->size(), 4U);
  EXPECT_NEAR(((*inner)[0] - Vec3(4, 4, 0)).norm(), 0.0, 1e-12);
}

TEST(Convex, ClockwiseInATiltedPlane) {
  const double s = std::sqrt(0.5);
  const auto polygon =
      ConvexPolygon::make({{0, 0, 0}, {0, 4 * s, 4 * s}, {10, 4 * s, 4 * s}, {10, 0, 0}});
  ASSERT_TRUE(polygon);
  const auto inner = (*polygon).inset(1.0);
  ASSERT_TRUE(inner);
  EXPECT_NEAR(((*inner)[0] - Vec3(1, s, s)).norm(), 0.0, 1e-12);
}

TEST(Convex, Refusals) {
  EXPECT_FALSE(ConvexPolygon::make({{0, 0, 0}, {1, 0, 0}, {1, 0.0001, 0}, {0, 1, 0}}));
  EXPECT_FALSE(ConvexPolygon::make({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(ConvexPolygon::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}));
  EXPECT_FALSE(ConvexPolygon::make({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}));
}

TEST(Convex, CoverageBySides) {
  EXPECT_TRUE(isNarrow(rectangle(10, 2), 2.0));
  EXPECT_FALSE(isNarrow(rectangle(10, 2), 1.9));
  EXPECT_EQ(coveringSide(rectangle(10, 2), 2.0), std::optional<std::size_t>(0));
  EXPECT_EQ(coveringSide(rectangle(10, 2), 1.9), std::nullopt);
  EXPECT_NEAR(sharpestSine(rectangle(3, 5)), std::sqrt(0.5), 1e-12);
}

}  // namespace
}  // namespace arelem::motion
