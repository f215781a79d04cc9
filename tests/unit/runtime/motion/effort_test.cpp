#include "runtime/motion/effort.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "runtime/geometry/least.h"
#include "runtime/motion/field.h"

namespace arelem::motion {
namespace {

void measure(Field& field, int times) {
  for (int i = 0; i < times; ++i) {
    static_cast<void>(field.at(Vec3::Zero(), Vec3::UnitZ()));
  }
}

// Three gaps for each cut vector, and for a hundred more.
TEST(Effort, IsSpentByGaps) {
  const auto field = makeField(surface::Plane{Vec3::UnitZ(), 0.0}, 1.0, {});
  Effort effort(3);
  measure(*field, 299);
  EXPECT_FALSE(effort.isSpent());
  measure(*field, 1);
  EXPECT_TRUE(effort.isSpent());
  effort.allow(2);
  EXPECT_FALSE(effort.isSpent());
  measure(*field, 6);
  EXPECT_TRUE(effort.isSpent());
}

TEST(NarrowLeast, FindsTheLeastAndEnds) {
  double best = 10.0;
  int looks = 0;
  const auto f = [&](double x) {
    ++looks;
    const double y = (x - 0.7) * (x - 0.7) + 2.0;
    best = std::min(best, y);
    return y;
  };
  geometry::narrowLeast(f, 0.0, 3.0, [](double, double width) { return width > 1e-6; });
  EXPECT_NEAR(best, 2.0, 1e-10);
  EXPECT_LT(looks, 40);
  looks = 0;
  geometry::narrowLeast(f, 0.0, 3.0, [](double value, double) { return value < 1.0; });
  EXPECT_EQ(looks, 2);
}

}  // namespace
}  // namespace arelem::motion
