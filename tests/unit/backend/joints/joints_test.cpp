#include <cmath>
#include <fstream>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "backend/joints/table.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using joints::Arm;
using joints::JointState;
using joints::Knot;
using joints::State;
using joints::Table;
using joints::Trajectory;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double degree = std::numbers::pi / 180.0;

robot::Machine pantograph() {
  robot::Machine machine;
  machine.pantograph.emplace();
  machine.acceleration = 1000.0;
  machine.blend = 0.1;
  return machine;
}
robot::Machine elbow() {
  robot::Machine machine;
  machine.elbow.emplace();
  return machine;
}
State standing(double x, double y) {
  State state;
  state.place[0] = x;
  state.place[1] = y;
  return state;
}
Knot knot(double x, double y, double speed) {
  Knot k;
  k.point = Vec3(x, y, 0.0);
  k.speed = speed;
  return k;
}
std::vector<std::string> codes(const CollectingSink& sink) {
  std::vector<std::string> list;
  for (const Diagnostic& d : sink.all()) {
    list.emplace_back(d.kind().code);
  }
  return list;
}

/// Cases BLANK-polar: all four quadrants.
TEST(Pantograph, PublishedEquations) {
  const Arm arm(pantograph());
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/stencil/cases_blank.json");
  int cases = 0;
  for (const auto& one : nlohmann::json::parse(in)) {
    if (one["id"].get<std::string>().starts_with("BLANK-polar")) {
      const auto joints = arm.jointsOf(standing(one["inputs"]["X"], one["inputs"]["Y"]), 0.0);
      EXPECT_NEAR(joints.place[0], one["expected"]["r"], 1e-9);
      EXPECT_NEAR(joints.place[1], one["expected"]["theta"], 1e-9);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 4);
}

/// Half the angle at the elbow is 60 degrees where the reach is one link: 14667 of 88000 counts.
TEST(Elbow, ReachOfOneLinkIsSixtyDegrees) {
  const Arm arm(elbow());
  const auto joints = arm.jointsOf(standing(0.0, 2794.0), 0.0);
  EXPECT_NEAR(joints.place[0], 60.0, 1e-9);
  EXPECT_NEAR(joints.place[1], 90.0, 1e-9);
  EXPECT_EQ(std::llround(joints.place[0] * arm.counts(0)), 14667);
  EXPECT_EQ(std::llround(joints.place[1] * arm.counts(1)), 22000);
  EXPECT_NEAR(arm.reach().high, 5588.0, 1e-9);
  EXPECT_NEAR(arm.reach().low, 0.0, 1e-9);
}

/// Closed derivatives against differences of places along a parabola in time.
TEST(Arm, SpeedsAndAccelerationsAreDerivatives) {
  for (const robot::Machine& machine : {pantograph(), elbow()}) {
    const Arm arm(machine);
    const auto tool = [](double t) {
      State s = standing(2000.0 + 300.0 * t - 80.0 * t * t, -1500.0 + 500.0 * t + 40.0 * t * t);
      s.speed[0] = 300.0 - 160.0 * t;
      s.speed[1] = 500.0 + 80.0 * t;
      s.acceleration[0] = -160.0;
      s.acceleration[1] = 80.0;
      return s;
    };
    constexpr double h = 1e-3;
    for (const double t : {0.0, 1.0, 2.5}) {
      const JointState a = arm.jointsOf(tool(t - h), 0.0);
      const JointState m = arm.jointsOf(tool(t), 0.0);
      const JointState b = arm.jointsOf(tool(t + h), 0.0);
      for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_NEAR(m.speed[j], (b.place[j] - a.place[j]) / (2.0 * h), 1e-4);
        EXPECT_NEAR(m.acceleration[j], (b.speed[j] - a.speed[j]) / (2.0 * h), 1e-4);
      }
      EXPECT_LT((arm.placeOf(m) - tool(t).place.head<2>()).norm(), 1e-9);
    }
  }
}

TEST(Arm, TurnGoesOnBehindTheArm) {
  const Arm arm(pantograph());
  EXPECT_NEAR(arm.jointsOf(standing(-1000.0, -100.0), 170.0).place[1],
              180.0 + std::atan2(100.0, 1000.0) / degree, 1e-9);
}

/// 100 mm at 100 mm/s with 1000 mm/s2: 0.1 s to speed over 5 mm, 0.9 s even, 0.1 s to rest. The
/// tool waits for a window at the stop in front and the mean lags by one.
TEST(Trajectory, OneMoveFromRestToRest) {
  Knot first = knot(0.0, 0.0, 0.0);
  first.stop = true;
  const Trajectory path({first, knot(100.0, 0.0, 100.0)}, 1000.0, 0.1);
  EXPECT_NEAR(path.duration(), 0.1 + 1.1 + 0.05 + 0.1, 1e-12);
  EXPECT_LT(path.at(0.1).place.norm(), 1e-9);
  EXPECT_NEAR(path.at(0.7).speed[0], 100.0, 1e-9);
  EXPECT_NEAR(path.at(0.7).acceleration[0], 0.0, 1e-9);
  EXPECT_NEAR(path.at(path.duration()).place[0], 100.0, 1e-9);
  EXPECT_NEAR(path.at(path.duration()).speed[0], 0.0, 1e-9);
  // Half way in place is half way in time.
  EXPECT_NEAR(path.at(0.1 + 0.05 + 0.55).place[0], 50.0, 1e-9);
}

/// A move too short for its speed: 10 mm take 2 sqrt(10 / 1000) = 0.2 s and reach 100 mm/s.
TEST(Trajectory, ShortMovesDoNotReachTheirSpeed) {
  const Trajectory path({knot(0.0, 0.0, 0.0), knot(10.0, 0.0, 900.0)}, 1000.0, 0.01);
  EXPECT_NEAR(path.duration(), 0.2 + 0.005 + 0.01, 1e-12);
}

TEST(Trajectory, StaysNearCornersAndIsSmooth) {
  const Trajectory path({knot(0.0, 0.0, 0.0), knot(300.0, 0.0, 200.0), knot(600.0, 60.0, 200.0)},
                        1000.0, 0.1);
  double nearest = 1e9;
  State before = path.at(0.0);
  constexpr double step = 1e-3;
  for (double t = step; t < path.duration(); t += step) {
    const State now = path.at(t);
    nearest =
        std::min(nearest, (now.place - (joints::Place() << 300, 0, 0, 0, 0).finished()).norm());
    // Speed is continuous, place is its integral.
    EXPECT_LT((now.speed - before.speed).norm(), 2.0 * 1000.0 * step * 1.01);
    EXPECT_LT((now.place - before.place - 0.5 * step * (now.speed + before.speed)).norm(), 1e-3);
    before = now;
  }
  EXPECT_LT(nearest, 1000.0 * 0.1 * 0.1 / 8.0);
}

/// Accelerations have no jumps: they are the derivative of the speed everywhere.
TEST(Trajectory, AccelerationIsContinuous) {
  const Trajectory path({knot(0.0, 0.0, 0.0), knot(30.0, 0.0, 200.0), knot(60.0, 6.0, 150.0),
                         knot(90.0, 30.0, 180.0)},
                        1000.0, 0.128);
  constexpr double step = 1e-4;
  for (double t = step; t < path.duration() - step; t += 3e-3) {
    const State before = path.at(t - step);
    const State now = path.at(t);
    const State behind = path.at(t + step);
    const joints::Place slope = (behind.speed - before.speed) / (2.0 * step);
    // It changes by at most 4 v / (window / 2)^2 a second.
    constexpr double jerk = 4.0 * 200.0 / (0.064 * 0.064);
    EXPECT_LT((slope - now.acceleration).norm(), jerk * step) << t;
    EXPECT_LT((behind.acceleration - now.acceleration).norm(), jerk * step) << t;
    EXPECT_LT((now.speed - (behind.place - before.place) / (2.0 * step)).norm(), 0.01) << t;
  }
}

TEST(Trajectory, StopsExactlyWhereItMust) {
  std::vector<Knot> knots = {knot(0.0, 0.0, 0.0), knot(300.0, 0.0, 200.0),
                             knot(300.0, 300.0, 200.0)};
  knots[1].stop = true;
  knots[1].dwell = 0.5;
  knots[1].gun = true;
  const Trajectory path(knots, 1000.0, 0.1);
  // 300 mm at 200 mm/s: 1.5 s and 0.2 s to speed and rest; the mean is at rest 0.1 s later.
  const State there = path.at(1.7 + 0.1);
  EXPECT_NEAR(there.place[0], 300.0, 1e-9);
  EXPECT_NEAR(there.speed.norm(), 0.0, 1e-9);
  EXPECT_FALSE(path.at(1.79).gun);
  EXPECT_TRUE(path.at(1.81).gun);
  EXPECT_NEAR(path.at(2.29).place[1], 0.0, 1e-9);
}

std::string table(const std::vector<cl::Record>& records,
                  const robot::Machine& machine,
                  CollectingSink& sink,
                  std::string_view target = "joints") {
  backend::Context context;
  context.machine = &machine;
  return written(target, records, context, sink);
}
cl::Record go(std::vector<double> numbers) {
  cl::Motion m;
  m.withAxis = numbers.size() >= 6;
  m.withSide = numbers.size() == 9;
  m.coordinates = std::move(numbers);
  return record(1, std::move(m));
}
cl::Record word(Word which, std::vector<cl::Value> values = {}) {
  return record(1, cl::Post{which, "", std::move(values)});
}

double numberBehind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  EXPECT_NE(at, std::string::npos) << text;
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
}

TEST(JointTable, RowsStandAtAnEvenInterval) {
  CollectingSink sink;
  robot::Machine machine = pantograph();
  machine.interval = 0.25;
  machine.pantograph->countsPerMillimeter = 100.0;
  const std::string text = table(
      {go({2500, 0, 300}), word(Word::FEDRAT, {500.0, Word::MMPS}),
       word(Word::SPRAY, {Word::ON, 1.0}), go({3500, 0, 300}), word(Word::SPRAY, {Word::OFF, 1.0})},
      machine, sink);
  // 2 s, and the quarter of a second more in which it speeds up and stops: its film is thicker.
  ASSERT_THAT(codes(sink), ElementsAre("W0684"));
  EXPECT_NEAR(numberBehind(sink.all()[0].message, "s, "), 2.0, 1e-9);
  const std::vector<std::string> rows = lines(text);
  EXPECT_EQ(rows[0],
            "index,time_s,gun,actuator_mm,turn_deg,actuator_mm_s,turn_deg_s,actuator_mm_s2,"
            "turn_deg_s2,actuator_counts,x_mm,y_mm,z_mm,heading_deg,tilt_deg");
  EXPECT_EQ(rows[1],
            "0,0.000000,0,300.000000,0.000000,0.0000,0.0000,0.0000,0.0000,30000,"
            "2500.000,0.000,300.000,0.000,0.000");
  // At 1 s the tool goes 500 mm/s, the actuator 3/25 of that.
  EXPECT_THAT(rows[5], StartsWith("4,1.000000,1,"));
  EXPECT_THAT(rows[5], HasSubstr(",60.0000,0.0000,0.0000,0.0000,"));
  // 1000 mm at 500 mm/s and half a second to speed and to rest: 2.5 s; windows at both stops.
  EXPECT_THAT(rows.back(), HasSubstr(",420.000000,0.000000,0.0000,0.0000,0.0000,0.0000,42000,"));
}

TEST(JointTable, TellsWhatCannotBeReached) {
  const cl::Record slow = word(Word::FEDRAT, {100.0, Word::MMPS});
  const auto codeOf = [](const std::vector<cl::Record>& records, const robot::Machine& machine) {
    CollectingSink sink;
    EXPECT_EQ(table(records, machine, sink), "");
    return codes(sink);
  };
  // The actuator reaches 1000 mm: 8333 mm.
  EXPECT_THAT(codeOf({go({9000, 0, 0})}, pantograph()), ElementsAre("E0681"));
  EXPECT_THAT(codeOf({slow, go({1000, -1000, 0}), go({-1000, 1000, 0})}, pantograph()),
              ElementsAre("E0682"));
  robot::Machine narrow = pantograph();
  narrow.pantograph->turn = {-30.0, 30.0};
  EXPECT_THAT(codeOf({slow, go({1000, 0, 0}), go({0, 1000, 0})}, narrow), ElementsAre("E0683"));
  EXPECT_THAT(codeOf({go({1000, 0, 0})}, robot::Machine{}), ElementsAre("E0680"));
  robot::Machine both = pantograph();
  both.elbow.emplace();
  EXPECT_THAT(codeOf({go({1000, 0, 0})}, both), ElementsAre("E0680"));
  EXPECT_THAT(codeOf({go({1000, 0, 0, 0.6, 0, 0.8})}, pantograph()), ElementsAre("E0664"));
  EXPECT_THAT(codeOf({go({1000, 0, 0}), word(Word::FEDRAT, {-3.0})}, pantograph()),
              ElementsAre("E0621"));
  // A gun that leans along its side needs a tilt axis, and one that goes so far.
  const double b = 10.0 * degree;
  const cl::Record leaning =
      go({1000, 0, 0, std::sin(b), 0, std::cos(b), std::cos(b), 0, -std::sin(b)});
  EXPECT_THAT(codeOf({leaning}, pantograph()), ElementsAre("E0664"));
  robot::Machine tilting = pantograph();
  tilting.tilt.emplace().most = 9.0;
  EXPECT_THAT(codeOf({leaning}, tilting), ElementsAre("E0665"));
}

/// 3000 mm/s outwards need 360 mm/s of an actuator that has 200: 0.5556 of the speed would do.
TEST(JointTable, LimitsNameTheFactorThatWouldDo) {
  robot::Machine machine = pantograph();
  machine.acceleration = 10000.0;
  machine.pantograph->acceleration = {1e4, 1e4};
  CollectingSink sink;
  table({go({1000, 0, 0}), word(Word::FEDRAT, {3000.0, Word::MMPS}), go({7000, 0, 0})}, machine,
        sink);
  ASSERT_THAT(codes(sink), ElementsAre("E0684"));
  EXPECT_THAT(sink.all()[0].message, HasSubstr("joint actuator needs 360 mm/s"));
  EXPECT_THAT(sink.all()[0].message, HasSubstr("its largest is 200; "));
  EXPECT_LE(numberBehind(sink.all()[0].message, "among them, "), 200.0 / 360.0);
  EXPECT_GT(numberBehind(sink.all()[0].message, "among them, "), 0.96 * 200.0 / 360.0);
  // 10000 mm/s2 need 1200 mm/s2 of the actuator; a quarter of that is half of the speed.
  machine.pantograph->speed = {1e4, 1e4};
  machine.pantograph->acceleration = {300.0, 1e4};
  CollectingSink other;
  table({go({1000, 0, 0}), word(Word::FEDRAT, {3000.0, Word::MMPS}), go({7000, 0, 0})}, machine,
        other);
  ASSERT_THAT(codes(other), ElementsAre("E0685"));
  EXPECT_THAT(other.all()[0].message, HasSubstr("needs 1200 mm/s2"));
  const double factor = numberBehind(other.all()[0].message, ", or ");
  EXPECT_LE(factor, 0.5);
  EXPECT_GT(factor, 0.49);
  EXPECT_NEAR(numberBehind(other.all()[0].message, "acceleration = "), factor * factor * 1e4, 1.0);
}

/// 3000 mm/s where the tool point goes 1200: the fastest move is named, and 0.4.
TEST(JointTable, TheFastestMoveIsNamed) {
  robot::Machine machine = pantograph();
  machine.speed = 1200.0;
  CollectingSink sink;
  EXPECT_EQ(table({go({1000, 0, 0}), word(Word::FEDRAT, {1500.0, Word::MMPS}), go({2000, 0, 0}),
                   word(Word::FEDRAT, {3000.0, Word::MMPS}), go({3000, 0, 0})},
                  machine, sink),
            "");
  ASSERT_THAT(codes(sink), ElementsAre("E0666"));
  EXPECT_THAT(sink.all()[0].message,
              HasSubstr("location 3 has 3000 mm/s; the robot's largest speed is 1200, 0.4 times"));
}

/// At full stretch an elbow has no bounded speed; nothing is written as "nan".
TEST(JointTable, FullStretchIsRefused) {
  robot::Machine machine;
  machine.elbow.emplace();  // two links of 2794
  CollectingSink sink;
  table({go({5588, 0, 0}), word(Word::FEDRAT, {10.0, Word::MMPS}), go({5000, 0, 0})}, machine,
        sink);
  EXPECT_THAT(codes(sink), testing::Contains("E0689"));
}

TEST(JointTable, ACutWithoutAFeedIsRefused) {
  CollectingSink sink;
  EXPECT_EQ(table({go({1000, 0, 0}), go({1500, 0, 0})}, pantograph(), sink), "");
  EXPECT_THAT(codes(sink), ElementsAre("E0671"));
}

TEST(JointTable, TooManyRowsAreRefused) {
  CollectingSink sink;
  table({go({1000, 0, 0}), word(Word::FEDRAT, {0.001, Word::MMPS}), go({7000, 0, 0})}, pantograph(),
        sink);
  EXPECT_THAT(codes(sink), ElementsAre("E0686"));
}

TEST(JointTable, WordsWithoutAPlaceAreTold) {
  CollectingSink sink;
  table({go({1000, 0, 0}), word(Word::COOLNT, {Word::ON}), word(Word::COOLNT, {Word::OFF})},
        pantograph(), sink);
  EXPECT_THAT(codes(sink), ElementsAre("W0687"));
}

TEST(JointPlot, HasAPanelForEachQuantity) {
  CollectingSink sink;
  const std::string text =
      table({go({1000, 0, 0}), word(Word::FEDRAT, {100.0, Word::MMPS}), go({1500, 400, 0})},
            pantograph(), sink, "joint-plots");
  for (const char* title : {"path of the tool", "actuator, mm", "speed of the actuator, mm/s",
                            "acceleration of the actuator, mm/s2", "turn, deg",
                            "speed of the turn, deg/s", "acceleration of the turn, deg/s2"}) {
    EXPECT_THAT(text, HasSubstr(title));
  }
  EXPECT_THAT(text, HasSubstr("</svg>"));
}

}  // namespace
}  // namespace arelem::test
