#include <cmath>

#include <gtest/gtest.h>

#include "runtime/certify/motion_check.h"

namespace arelem::certify {
namespace {

constexpr double band = 0.01;
const Vec3 up = Vec3::UnitZ();

TEST(PathEnd, AStepShorterThanTheBandTellsNoDirection) {
  PathEnd end({Vec3::Zero(), up}, band);
  end.moveTo({Vec3(1.0, 0.0, 0.0), up});
  // From one side of the band to the other, backwards.
  end.moveTo({Vec3(0.999, 0.005, 0.0), up});
  EXPECT_TRUE(end.towards(Vec3::Zero()).isApprox(Vec3::UnitX()));
  EXPECT_EQ(end.place().toolEnd, Vec3(0.999, 0.005, 0.0));
}

TEST(PathEnd, ManyShortStepsDo) {
  PathEnd end({Vec3::Zero(), up}, band);
  end.moveTo({Vec3(1.0, 0.0, 0.0), up});
  for (int i = 1; i <= 10; ++i) {
    end.moveTo({Vec3(1.0, 0.004 * i, 0.0), up});
  }
  EXPECT_TRUE(end.towards(Vec3::Zero()).isApprox(Vec3::UnitY()));
}

TEST(PathEnd, BeforeAnythingLongerTheShortStepsCount) {
  PathEnd end({Vec3::Zero(), up}, band);
  EXPECT_TRUE(end.towards(Vec3::Zero()).isZero());
  end.moveTo({Vec3(0.0, 0.001, 0.0), up});
  EXPECT_TRUE(end.towards(Vec3::Zero()).isApprox(Vec3::UnitY()));
}

TEST(PathEnd, PointsOfATurningToolHaveWaysOfTheirOwn) {
  // The tool end goes by 1 along x while the axis leans back by 0.5: a point 4 up the axis goes by
  // 1 - 4 * 0.5 = -1.
  PathEnd end({Vec3::Zero(), up}, band);
  end.moveTo({Vec3(1.0, 0.0, 0.0), Vec3(-std::sin(0.5), 0.0, std::cos(0.5))});
  EXPECT_TRUE(end.towards(Vec3::Zero()).isApprox(Vec3::UnitX()));
  EXPECT_TRUE(end.towards(4.0 * up).isApprox(-Vec3::UnitX()));
}

}  // namespace
}  // namespace arelem::certify
