// Sections lie equally far apart on the surface, not in space.
#include "runtime/spray/surface/ground.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/spray/surface/section_planes.h"

namespace arelem::spray {
namespace {

TEST(Ground, TheSteepestPieceCounts) {
  // 0 to 1 once, 1 to 3 the threefold of the piece that leans most there.
  const Ground ground({{0.0, 3.0, 1.0}, {1.0, 3.0, 3.0}, {1.5, 2.0, 2.0}, {5.0, 6.0, 9.0}}, 0.0,
                      3.0);
  EXPECT_DOUBLE_EQ(ground.length(), 1.0 + 2.0 * 3.0);
  EXPECT_DOUBLE_EQ(ground.levelAt(0.5), 0.5);
  EXPECT_DOUBLE_EQ(ground.levelAt(1.0), 1.0);
  EXPECT_DOUBLE_EQ(ground.levelAt(4.0), 2.0);
  EXPECT_DOUBLE_EQ(ground.levelAt(7.0), 3.0);
}

TEST(Ground, NothingLiesInAGap) {
  const Ground ground({{0.0, 1.0, 1.0}, {4.0, 5.0, 1.0}}, 0.0, 5.0);
  EXPECT_DOUBLE_EQ(ground.length(), 2.0);
  EXPECT_DOUBLE_EQ(ground.levelAt(1.5), 4.5);
}

SurfaceJob job(Patch patch, double across) {
  SurfaceJob job;
  job.patch = std::move(patch);
  job.gun.footprint = {across, across};
  job.lines = SurfaceJob::Parallel{Vec3::UnitZ()};
  return job;
}

TEST(SectionPlanes, OfAConeFollowItsSlope) {
  // Half angle 60 degrees: 100 along the slope are 50 of height.
  Patch cone;
  cone.at = [](double u, double v) {
    const double arm = v * std::sin(std::numbers::pi / 3.0);
    return Vec3(arm * std::cos(u), arm * std::sin(u), v / 2.0);
  };
  cone.u1 = 2.0 * std::numbers::pi;
  cone.v0 = 100.0;
  cone.v1 = 500.0;
  const Result<SectionPlanes> planes = sectionPlanes(job(cone, 50.0), 50.0);
  ASSERT_TRUE(planes.ok());
  ASSERT_EQ(planes->levels.size(), 9U);
  EXPECT_NEAR(planes->step, 50.0, 0.05);
  const Vec3 outward(0.5, 0.0, -std::sqrt(3.0) / 2.0);
  for (std::size_t i = 1; i < 9; ++i) {
    EXPECT_NEAR(planes->levels[i] - planes->levels[i - 1], 25.0, 1e-3);
    EXPECT_NEAR(planes->apartAt(i, cone.at(0.0, 300.0), outward), 50.0, 1e-2);
    EXPECT_NEAR(planes->apartAt(i, cone.at(0.0, 300.0), Vec3::UnitX()), 25.0, 1e-2);
  }
}

TEST(SectionPlanes, OfABallLieAtEqualLatitudes) {
  Patch ball;
  ball.at = [](double u, double v) {
    return Vec3(100.0 * std::cos(v) * std::cos(u), 100.0 * std::cos(v) * std::sin(u),
                100.0 * std::sin(v));
  };
  ball.u1 = 2.0 * std::numbers::pi;
  ball.v0 = -std::numbers::pi / 2.0;
  ball.v1 = std::numbers::pi / 2.0;
  // Half a turn of 314 in steps of 32: ten, half a step off the poles. Of the six degrees at each
  // pole that lean too much half are followed.
  const Result<SectionPlanes> planes = sectionPlanes(job(ball, 32.0), 32.0, {true, true});
  ASSERT_TRUE(planes.ok());
  ASSERT_EQ(planes->levels.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) {
    const double latitude = (static_cast<double>(i) + 0.5) / 10.0 * 180.0 - 90.0;
    EXPECT_NEAR(std::asin(planes->levels[i] / 100.0) * 180.0 / std::numbers::pi, latitude, 3.0);
  }
}

TEST(SectionPlanes, WhatLeansTooMuchIsNotFollowed) {
  // A lid that rises by 1 in 400 beside a wall of 100: planes are ten times as close over the lid.
  SectionPlanes planes;
  planes.levels = {0.0, 1.0, 2.0};
  planes.planes.resize(3);
  for (CuttingPlane& plane : planes.planes) {
    plane.normal = Vec3::UnitZ();
  }
  EXPECT_NEAR(planes.apartAt(1, Vec3::Zero(), Vec3::UnitZ()), 10.0, 1e-12);
  EXPECT_NEAR(planes.apartAt(1, Vec3::Zero(), Vec3::UnitX()), 1.0, 1e-12);
}

}  // namespace
}  // namespace arelem::spray
