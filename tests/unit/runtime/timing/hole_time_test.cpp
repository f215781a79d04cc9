// Drilling cycles in the time law. Expected seconds are way over feed, by pencil: the machine is so
// quick that nothing else counts.
#include <gtest/gtest.h>

#include "runtime/timing/cut_timer.h"

namespace arelem::timing {
namespace {

class HoleTime : public testing::Test {
 protected:
  void post(Word word, std::vector<cl::Value> values) {
    cl::Record record;
    record.body = cl::Post{word, "", std::move(values)};
    timer_.accept(record);
  }
  void at(std::vector<double> place, cl::Motion::Kind kind = cl::Motion::Kind::go) {
    cl::Record record;
    cl::Motion motion;
    motion.kind = kind;
    motion.withAxis = place.size() == 6;
    motion.coordinates = std::move(place);
    record.body = motion;
    timer_.accept(record);
  }
  CollectingSink sink_;
  CutTimer timer_{Machine{{1e9, 1e15, 1e24}, 0.0, 0.0}, sink_};
};

TEST_F(HoleTime, AHoleTakesTheFeedFromItsClearanceToItsBottom) {
  post(Word::FEDRAT, {600.0});
  at({0, 0, 50}, cl::Motion::Kind::from);
  post(Word::CYCLE, {Word::DRILL, 28.0, Word::MMPM, 60.0, 2.0});
  at({10, 0, 0});  // 30 mm at 1 mm/s
  at({20, 0, 0});
  post(Word::CYCLE, {Word::OFF});
  at({20, 0, 12});  // from the clearance: 10 mm at 10 mm/s, the feed before the cycle
  const TimeTable table = timer_.finish();
  EXPECT_NEAR(table.cutting, 61.0, 1e-3);
  EXPECT_NEAR(table.cuttingLength, 70.0, 1e-9);
  EXPECT_NEAR(table.rapidLength, std::hypot(10.0, 0.0) + 48.0 + 30.0 + 10.0 + 30.0, 1e-9);
  EXPECT_EQ(table.moves, 3U);
  EXPECT_EQ(sink_.errors(), 0U);
}

TEST_F(HoleTime, ADwellCountsAndATapGoesBackAtItsFeed) {
  at({0, 0, 3}, cl::Motion::Kind::from);
  post(Word::CYCLE, {Word::DRILL, 4.0, Word::MMPM, 60.0, 3.0, Word::DWELL, 0.5});
  at({0, 0, 0});
  EXPECT_EQ(sink_.errors(), 0U);
  post(Word::CYCLE, {Word::TAP, 6.0, Word::MMPM, 60.0, 3.0});
  at({0, 0, 0});
  const TimeTable table = timer_.finish();
  EXPECT_NEAR(table.dwell, 0.5, 1e-12);
  EXPECT_NEAR(table.cutting, 7.0 + 9.0 + 9.0, 1e-3);
}

TEST_F(HoleTime, AHoleFollowsTheToolAxis) {
  at({0, 0, 0, 1, 0, 0}, cl::Motion::Kind::from);
  post(Word::CYCLE, {Word::DRILL, 9.0, Word::MMPM, 60.0, 1.0});
  at({0, 0, 0, 1, 0, 0});
  EXPECT_NEAR(timer_.finish().cutting, 10.0, 1e-3);
}

TEST_F(HoleTime, AnUnknownCycleIsAnErrorAndNoGuess) {
  at({0, 0, 0}, cl::Motion::Kind::from);
  post(Word::CYCLE, {std::string("WEAVE"), 9.0});
  EXPECT_EQ(sink_.errors(), 1U);
}

}  // namespace
}  // namespace arelem::timing
