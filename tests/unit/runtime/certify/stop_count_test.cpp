#include "runtime/certify/stop_count.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/tool/profile.h"

namespace arelem::certify {
namespace {

constexpr double tolerance = 0.001;
const Vec3 up = Vec3::UnitZ();
/// Upright, of radius 10 at x = 60; the tool of diameter 10 runs along x at y, so it is clear of it
/// up to 15 and within it from 5 on.
const surface::AnySurface round = surface::Cylinder{Vec3(60.0, 0.0, 0.0), up, 10.0};
const tool::Profile cutter = *tool::makeProfile(std::vector<double>{10.0});

StopCount count(ir::Condition condition, int nth, const Vec3& from, double thick = 0.0) {
  const bool on = condition == ir::Condition::on;
  const StopWanted wanted{
      condition, nth, on ? nullptr : &cutter, thick, {0.0, tolerance, 0.0, false}, tolerance};
  return {round, wanted, {from, up}};
}

void go(StopCount& c, std::initializer_list<double> places, double y = 0.0) {
  for (const double x : places) {
    c.add({Vec3(x, y, 0.0), up});
  }
}

TEST(StopCount, TheFirstPositionFromAClearPlaceIsTo) {
  StopCount c = count(ir::Condition::to, 1, Vec3(0.0, 0.0, 0.0));
  go(c, {20.0, 45.0});
  EXPECT_FALSE(c.passed());
  EXPECT_FALSE(c.early());
  EXPECT_EQ(c.number(), 1);
  go(c, {45.0 + 0.5 * tolerance});
  EXPECT_FALSE(c.passed());  // within its tolerance
  go(c, {45.0 + 1.9 * tolerance});
  EXPECT_FALSE(c.passed());  // the cut vectors may stray as much as that
  go(c, {45.0 + 2.6 * tolerance});
  EXPECT_TRUE(c.passed());
  EXPECT_EQ(c.passedVector(), 4U);
  EXPECT_NEAR(c.passedAt().x(), 45.0 + 2.6 * tolerance, tolerance);
}

TEST(StopCount, OneCutVectorOverAllOfItIsSeen) {
  StopCount to = count(ir::Condition::to, 1, Vec3(0.0, 0.0, 0.0));
  go(to, {200.0});
  EXPECT_TRUE(to.passed());
  EXPECT_NEAR(to.passedAt().x(), 45.0, 0.3);
  StopCount on = count(ir::Condition::on, 2, Vec3(0.0, 0.0, 0.0));
  go(on, {200.0});
  EXPECT_TRUE(on.passed());
  EXPECT_NEAR(on.passedAt().x(), 70.0, 0.3);
}

TEST(StopCount, PastComesBehindTo) {
  // Within the circle the tool is clear again from 55 to 65.
  StopCount c = count(ir::Condition::past, 1, Vec3(0.0, 0.0, 0.0));
  go(c, {55.0});
  EXPECT_FALSE(c.passed());
  EXPECT_FALSE(c.early());
  go(c, {58.0});
  EXPECT_TRUE(c.passed());
}

TEST(StopCount, ASecondPositionIsNotTheFirst) {
  StopCount on = count(ir::Condition::on, 2, Vec3(0.0, 0.0, 0.0));
  go(on, {50.0});
  EXPECT_TRUE(on.early());
  EXPECT_EQ(on.number(), 1);
  go(on, {70.0});
  EXPECT_FALSE(on.early());
  EXPECT_FALSE(on.passed());
  EXPECT_EQ(on.number(), 2);
  StopCount to = count(ir::Condition::to, 2, Vec3(0.0, 0.0, 0.0));
  go(to, {45.0});
  EXPECT_TRUE(to.early());
  EXPECT_EQ(to.number(), 1);
  go(to, {65.0});
  EXPECT_FALSE(to.early());
  EXPECT_EQ(to.number(), 2);
  EXPECT_FALSE(to.passed());
  go(to, {67.0});
  EXPECT_TRUE(to.passed());
}

TEST(StopCount, FromWithinTheFirstPositionIsPast) {
  StopCount past = count(ir::Condition::past, 1, Vec3(50.0, 0.0, 0.0));
  go(past, {55.0});
  EXPECT_FALSE(past.early());
  EXPECT_FALSE(past.passed());
  StopCount to = count(ir::Condition::to, 1, Vec3(50.0, 0.0, 0.0));
  go(to, {65.0});
  EXPECT_FALSE(to.early());
  EXPECT_FALSE(to.passed());
}

TEST(StopCount, AStartWithinTheToleranceDoesNotCount) {
  StopCount c = count(ir::Condition::to, 1, Vec3(45.0, 0.0, 0.0));
  EXPECT_FALSE(c.early());
  go(c, {30.0});
  EXPECT_FALSE(c.passed());
  go(c, {45.0});
  EXPECT_FALSE(c.early());
  EXPECT_FALSE(c.passed());
}

TEST(StopCount, AVisitWithinTheToleranceMayCountOrNot) {
  // Beside the circle by the radius of the tool: TO and PAST at one place.
  StopCount c = count(ir::Condition::past, 2, Vec3(0.0, 15.0, 0.0));
  go(c, {120.0}, 15.0 + 0.5 * tolerance);
  EXPECT_FALSE(c.passed());
  go(c, {60.0}, 15.0 + 0.5 * tolerance);
  EXPECT_FALSE(c.early());
  StopCount first = count(ir::Condition::past, 1, Vec3(0.0, 15.0, 0.0));
  go(first, {120.0}, 15.0 + 0.5 * tolerance);
  EXPECT_FALSE(first.passed());
  StopCount none = count(ir::Condition::past, 2, Vec3(0.0, 15.1, 0.0));
  go(none, {120.0}, 15.1);
  EXPECT_TRUE(none.early());
}

TEST(StopCount, ThickIsPartOfTheTool) {
  StopCount c = count(ir::Condition::to, 1, Vec3(0.0, 0.0, 0.0), 2.0);
  go(c, {43.0});
  EXPECT_FALSE(c.passed());
  go(c, {44.0});
  EXPECT_TRUE(c.passed());
}

TEST(StopCount, WhatATurnAtTheStartMeetsDoesNot) {
  // Leaning by 0.9 the tool of height 5 goes over the circle's edge at 50; upright it is clear.
  const Vec3 leaning(std::sin(0.9), 0.0, std::cos(0.9));
  const StopWanted wanted{ir::Condition::to, 1, &cutter, 0.0, {0.0, tolerance, 0.0, false},
                          tolerance};
  StopCount c(round, wanted, {Vec3(44.0, 0.0, 0.0), up});
  c.add({Vec3(44.0, 0.0, 0.0), leaning});
  EXPECT_FALSE(c.passed());
  c.add({Vec3(20.0, 0.0, 0.0), leaning});
  EXPECT_FALSE(c.passed());
  c.add({Vec3(20.0, 0.0, 0.0), up});
  c.add({Vec3(45.0, 0.0, 0.0), up});
  EXPECT_FALSE(c.early());
}

}  // namespace
}  // namespace arelem::certify
