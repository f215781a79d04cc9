#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ir/hole/steps.h"

namespace arelem::test {
namespace {

using hole::Cycle;
using hole::Cycles;
using hole::Step;
using testing::ElementsAre;

cl::Post cycle(std::vector<cl::Value> values) {
  return {Word::CYCLE, "", std::move(values)};
}

/// The steps in short: r and f with the height over the location, w with the seconds.
std::vector<std::string> stepsOf(std::vector<cl::Value> values) {
  const auto read = hole::readCycle(cycle(std::move(values)));
  EXPECT_TRUE(read.ok());
  const auto steps = hole::stepsOf(*read);
  EXPECT_TRUE(steps.ok());
  std::vector<std::string> all;
  for (const Step& step : *steps) {
    all.push_back(
        step.kind == Step::Kind::dwell
            ? fmt::format("w{:g}", step.seconds)
            : fmt::format("{}{:g}", step.kind == Step::Kind::rapid ? 'r' : 'f', step.height));
  }
  return all;
}

TEST(Hole, DrillingGoesDownWithTheFeedAndUpRapidly) {
  EXPECT_THAT(stepsOf({Word::DRILL, 8.0, Word::MMPM, 90.0, 2.0}), ElementsAre("r2", "f-8", "r2"));
}

TEST(Hole, ADwellStandsAtTheBottom) {
  EXPECT_THAT(stepsOf({Word::DRILL, 4.0, Word::MMPM, 80.0, 2.0, Word::DWELL, 0.5}),
              ElementsAre("r2", "f-4", "w0.5", "r2"));
}

/// 9 deep in pecks of 4: 4, 8, 9; back in to 2 above the bottom, the clearance.
TEST(Hole, PecksLeaveTheHole) {
  EXPECT_THAT(stepsOf({Word::DEEP, 9.0, Word::MMPM, 70.0, 2.0, Word::STEP, 4.0}),
              ElementsAre("r2", "f-4", "r2", "r-2", "f-8", "r2", "r-6", "f-9", "r2"));
}

TEST(Hole, BoringFeedsOutAgain) {
  EXPECT_THAT(stepsOf({Word::BORE, 6.0, Word::MMPM, 50.0, 2.0}), ElementsAre("r2", "f-6", "f2"));
  EXPECT_THAT(stepsOf({Word::BORE, 6.0, Word::MMPM, 50.0, 2.0, Word::DWELL, 1.0}),
              ElementsAre("r2", "f-6", "w1", "f2"));
}

TEST(Hole, ARetractIsHigherThanTheClearance) {
  EXPECT_THAT(stepsOf({Word::DRILL, 6.0, Word::MMPM, 50.0, 2.0, std::string("RTRCTO"), 12.0}),
              ElementsAre("r2", "f-6", "r2", "r12"));
}

TEST(Hole, TapsHaveNoMoves) {
  const auto read = hole::readCycle(cycle({Word::TAP, 9.0, Word::MMPM, 80.0, 2.0}));
  ASSERT_TRUE(read.ok());
  const auto steps = hole::stepsOf(*read);
  ASSERT_FALSE(steps.ok());
  EXPECT_EQ(steps.failure().row->code, "E0673");
}

/// Each peck is several moves where it is written out: for DEEP and BRKCHP alike.
TEST(Hole, TooManyPecksAreRefused) {
  Cycles cycles;
  EXPECT_FALSE(cycles.read(cycle({Word::DEEP, 9.0, Word::MMPM, 7.0, 2.0, Word::STEP, 1e-6})).ok());
  EXPECT_EQ(cycles.now(), nullptr);
  EXPECT_TRUE(cycles.read(cycle({Word::DEEP, 9.0, Word::MMPM, 7.0, 2.0, Word::STEP, 1e-3})).ok());
  EXPECT_NE(cycles.now(), nullptr);
}

TEST(Hole, CyclesEndAndGoOn) {
  Cycles cycles;
  EXPECT_TRUE(cycles.read(cycle({Word::ON})).ok());
  EXPECT_TRUE(cycles.objection().has_value());  // a location, and no cycle to go on with
  EXPECT_FALSE(cycles.objection().has_value());
  EXPECT_TRUE(cycles.read(cycle({Word::ON})).ok());  // the head of the cycle behind it
  EXPECT_TRUE(cycles.read(cycle({Word::DRILL, 8.0, Word::MMPM, 90.0, 2.0})).ok());
  ASSERT_NE(cycles.now(), nullptr);
  EXPECT_EQ(cycles.now()->depth, 8.0);
  EXPECT_FALSE(cycles.objection().has_value());
  for (const Word end : {Word::OFF, Word::NOMORE}) {
    EXPECT_TRUE(cycles.read(cycle({end})).ok());
    EXPECT_EQ(cycles.now(), nullptr);
    EXPECT_TRUE(cycles.read(cycle({Word::ON})).ok());
    EXPECT_NE(cycles.now(), nullptr);
  }
}

/// From below the clearance up first, from above it across at that height.
TEST(Hole, TheWayOverAHoleIsNeverBelowItsClearance) {
  const Vec3 clear(10, 0, 2);
  EXPECT_THAT(hole::wayOver({0, 0, 0}, clear, Vec3::UnitZ()), ElementsAre(Vec3(0, 0, 2), clear));
  EXPECT_THAT(hole::wayOver({0, 0, 20}, clear, Vec3::UnitZ()), ElementsAre(Vec3(10, 0, 20)));
}

}  // namespace
}  // namespace arelem::test
