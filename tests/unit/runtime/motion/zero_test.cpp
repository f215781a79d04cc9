#include "runtime/motion/zero.h"

#include <gtest/gtest.h>

namespace arelem::motion {
namespace {

std::optional<double> cubic(double s) {
  return (s - 0.4) * (s - 0.5) * (s - 3.0);
}

TEST(Zero, IsTheOneBetween) {
  const auto zero = zeroBetween(cubic, 2.0, 4.0);
  ASSERT_TRUE(zero);
  EXPECT_NEAR(*zero, 3.0, 1e-12);
}

// The slope of a gap is negative up to a dip, between two touches next to each other positive, and
// negative again up to a third one.
TEST(Zero, BesideIsTheNearest) {
  const auto ahead = zeroBetween(cubic, 0.0, 0.01);
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(*ahead, 0.4, 1e-12);
  const auto behind = zeroBetween(cubic, 0.8, 0.81);
  ASSERT_TRUE(behind);
  EXPECT_NEAR(*behind, 0.5, 1e-12);
}

TEST(Zero, NoneWhereTheSignStays) {
  EXPECT_FALSE(
      zeroBetween([](double s) -> std::optional<double> { return 1.0 + s * s; }, 0.0, 1.0));
}

}  // namespace
}  // namespace arelem::motion
