// Turning axes: the inverse by forward kinematics, and by the formulas of the trade.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "backend/robot/machine.h"
#include "backend/robot/turned_move.h"

namespace arelem::robot {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;
using Kind = Turning::Kind;

Vec3 directionOf(char letter) {
  return Vec3::Unit(letter - 'A');
}

Turning machineOf(Kind kind, char first, char second) {
  Turning turning;
  turning.kind = kind;
  turning.axes[0] = {first, directionOf(first), Vec3(10, -20, 150)};
  turning.axes[1] = {second, directionOf(second), Vec3(-5, 3, 140)};
  return turning;
}

/// All machines of two letters that can point the tool anywhere: a tilt and a turn about z, or in
/// the other order with two tilts.
std::vector<Turning> machines() {
  return {machineOf(Kind::tableTable, 'A', 'C'), machineOf(Kind::tableTable, 'B', 'C'),
          machineOf(Kind::headHead, 'C', 'B'),   machineOf(Kind::headHead, 'C', 'A'),
          machineOf(Kind::headTable, 'B', 'C'),  machineOf(Kind::headTable, 'A', 'C')};
}

Vec3 randomAxis(std::mt19937& random) {
  std::normal_distribution<double> one;
  return Vec3(one(random), one(random), one(random)).normalized();
}

TEST(Turning, ForwardOfInverseIsThePose) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-300.0, 300.0);
  for (const Turning& turning : machines()) {
    for (int i = 0; i < 300; ++i) {
      const Vec3 axis = randomAxis(random);
      const Vec3 end(place(random), place(random), place(random));
      const std::vector<Angles> all = anglesFor(turning, axis, {0, 0});
      ASSERT_EQ(all.size(), 2U);
      for (const Angles& angles : all) {
        const ToolPose pose = toolPose(turning, linearAxes(turning, end, angles), angles);
        EXPECT_LT((pose.end - end).norm(), 1e-9);
        EXPECT_LT((pose.axis - axis).norm(), 1e-9);
      }
    }
  }
}

/// The same by homogeneous matrices, written out: the part turns with the table, the tool with the
/// head about points that are measured from the tool end, and the linear axes carry the head.
TEST(Turning, ForwardIsTheChainOfMatrices) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> turn(-170.0, 170.0);
  for (const Turning& turning : machines()) {
    const Angles angles{turn(random), turn(random)};
    const Vec3 linear(31, -42, 53);
    const auto about = [&](std::size_t i) {
      const TurningAxis& axis = turning.axes[i];
      return Eigen::Affine3d(Eigen::Translation3d(axis.point) *
                             Eigen::AngleAxisd(angles[i] / degrees, axis.direction) *
                             Eigen::Translation3d(-axis.point));
    };
    Eigen::Affine3d table = Eigen::Affine3d::Identity();
    Eigen::Affine3d head(Eigen::Translation3d{linear});
    switch (turning.kind) {
      case Kind::tableTable:
        table = about(0) * about(1);
        break;
      case Kind::headHead:
        head = head * about(0) * about(1);
        break;
      case Kind::headTable:
        table = about(1);
        head = head * about(0);
        break;
    }
    const Eigen::Affine3d tool = table.inverse() * head;
    const ToolPose pose = toolPose(turning, linear, angles);
    EXPECT_LT((pose.end - tool.translation()).norm(), 1e-9);
    EXPECT_LT((pose.axis - tool.linear() * Vec3::UnitZ()).norm(), 1e-12);
  }
}

TEST(Turning, FormulasOfTheTrade) {
  const Vec3 axis = Vec3(0.3, -0.4, 0.8).normalized();
  const double tilt = std::acos(axis.z()) * degrees;
  const auto holds = [&](Kind kind, char first, char second, Angles wanted) {
    const auto all = anglesFor(machineOf(kind, first, second), axis, {0, 0});
    return std::any_of(all.begin(), all.end(), [&](const Angles& one) {
      return std::abs(one[0] - wanted[0]) < 1e-9 && std::abs(one[1] - wanted[1]) < 1e-9;
    });
  };
  const double c = std::atan2(axis.x(), axis.y()) * degrees;
  EXPECT_TRUE(holds(Kind::tableTable, 'A', 'C', {tilt, c}));
  const double head = std::atan2(axis.y(), axis.x()) * degrees;
  EXPECT_TRUE(holds(Kind::headHead, 'C', 'B', {head, tilt}));
}

TEST(Turning, NutatingHeadOf45Degrees) {
  Turning turning = machineOf(Kind::headHead, 'C', 'B');
  turning.axes[1].direction = Vec3(0, 1, 1).normalized();
  std::mt19937 random(5);
  int reached = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = randomAxis(random);
    const auto all = anglesFor(turning, axis, {0, 0});
    // Half a turn about the slanted axis lays the tool level; lower it does not go.
    EXPECT_EQ(all.empty(), axis.z() < 0.0) << axis.z();
    for (const Angles& angles : all) {
      EXPECT_LT((toolPose(turning, Vec3::Zero(), angles).axis - axis).norm(), 1e-9);
      ++reached;
    }
  }
  EXPECT_GT(reached, 100);
  const Result<Angles> below = nextAngles(turning, Vec3(0, 0.6, -0.8), {0, 0});
  ASSERT_FALSE(below.ok());
  EXPECT_EQ(below.failure().row->code, "E0677");
}

TEST(Turning, NearestSolutionInTheRanges) {
  Turning turning = machineOf(Kind::tableTable, 'A', 'C');
  turning.axes[0].low = -120;
  turning.axes[0].high = 30;
  const Vec3 axis(0.8, 0, 0.6);  // A 53.13 and C 90, or A -53.13 and C -90
  const Result<Angles> found = nextAngles(turning, axis, {0, 350});
  ASSERT_TRUE(found.ok());
  EXPECT_NEAR((*found)[0], -std::acos(0.6) * degrees, 1e-9);
  EXPECT_NEAR((*found)[1], 270.0, 1e-9);  // -90 and a turn
  turning.axes[0].low = -30;
  EXPECT_EQ(nextAngles(turning, axis, {0, 0}).failure().row->code, "E0678");
}

TEST(Turning, UprightToolKeepsItsTurn) {
  const Turning turning = machineOf(Kind::tableTable, 'A', 'C');
  const Result<Angles> found = nextAngles(turning, Vec3::UnitZ(), {20, 77});
  ASSERT_TRUE(found.ok());
  EXPECT_NEAR((*found)[0], 0.0, 1e-9);
  EXPECT_NEAR((*found)[1], 77.0, 1e-9);
}

/// Places between which all axes move evenly: the tool keeps to the line and to the even turn.
TEST(TurnedMove, KeepsTheToolOnTheLine) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-200.0, 200.0);
  for (Turning turning : machines()) {
    turning.tolerance = 0.01;
    for (int i = 0; i < 20; ++i) {
      TurnedPlace from{{Vec3(place(random), place(random), place(random)), randomAxis(random)}, {}};
      from.angles = *nextAngles(turning, from.pose.axis, {0, 0});
      const ToolPose to{Vec3(place(random), place(random), place(random)),
                        (from.pose.axis + 0.3 * randomAxis(random)).normalized()};
      const auto places = turnedMove(turning, from, to);
      ASSERT_TRUE(places.ok());
      EXPECT_LT((places->back().pose.end - to.end).norm(), 1e-12);
      const Vec3 line = (to.end - from.pose.end).normalized();
      const Vec3 normal = from.pose.axis.cross(to.axis).normalized();
      TurnedPlace before = from;
      for (const TurnedPlace& now : *places) {
        const Vec3 start = linearAxes(turning, before.pose.end, before.angles);
        const Vec3 end = linearAxes(turning, now.pose.end, now.angles);
        for (double s = 0.0; s <= 1.0; s += 0.1) {
          const Angles angles{std::lerp(before.angles[0], now.angles[0], s),
                              std::lerp(before.angles[1], now.angles[1], s)};
          const ToolPose pose = toolPose(turning, start + s * (end - start), angles);
          EXPECT_LT((pose.end - from.pose.end).cross(line).norm(), 1.2 * turning.tolerance);
          EXPECT_LT(std::asin(std::abs(pose.axis.dot(normal))) * degrees,
                    1.2 * turning.angleTolerance);
        }
        before = now;
      }
    }
  }
}

TEST(TurnedMove, OneMoveWhereTheAxisStays) {
  const Turning turning = machineOf(Kind::tableTable, 'A', 'C');
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  TurnedPlace from{{Vec3(1, 2, 3), axis}, *nextAngles(turning, axis, {0, 0})};
  const auto places = turnedMove(turning, from, {Vec3(100, 50, -20), axis});
  ASSERT_TRUE(places.ok());
  EXPECT_EQ(places->size(), 1U);
}

TEST(TurnedMove, RefusesToUnwind) {
  Turning turning = machineOf(Kind::headHead, 'C', 'B');
  turning.axes[0].low = -180;
  turning.axes[0].high = 180;
  turning.axes[1].low = 0;
  turning.axes[1].high = 100;
  const auto axis = [](double azimuth) {
    return Vec3(0.5 * std::cos(azimuth / degrees), 0.5 * std::sin(azimuth / degrees),
                std::sqrt(0.75));
  };
  TurnedPlace from{{Vec3::Zero(), axis(170)}, {170, 30}};
  const auto refused = turnedMove(turning, from, {Vec3(10, 0, 0), axis(190)});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().row->code, "E0679");
  EXPECT_TRUE(turnedMove(turning, from, {Vec3(10, 0, 0), axis(150)}).ok());
}

TEST(MachineFile, ControlAndTurningAxes) {
  const auto machine = readMachine(
      "[control]\nunits = \"inch\"\nend = \"M30\"\ncycles = false\noffset = \"\"\n"
      "[turning]\nkinematics = \"head-table\"\naxes = [\"B\", \"C\"]\ntool_point = true\n"
      "[turning.B]\ndirection = [0, 1, 1]\npoint = [0, 0, 180]\nrange = [-90, 90]\n"
      "[time]\nvelocity = 100.0\n",
      "m.toml");
  ASSERT_TRUE(machine.ok()) << machine.failure().message;
  EXPECT_TRUE(machine->control->inches);
  EXPECT_EQ(machine->control->decimals, 5);
  EXPECT_EQ(machine->control->end, "M30");
  EXPECT_EQ(machine->control->offset, "");
  ASSERT_TRUE(machine->turning);
  EXPECT_EQ(machine->turning->kind, Kind::headTable);
  EXPECT_NEAR(machine->turning->axes[0].direction.y(), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(machine->turning->axes[0].point, Vec3(0, 0, 180));
  EXPECT_EQ(machine->turning->axes[1].letter, 'C');
  EXPECT_EQ(machine->time->velocity, 100.0);
  EXPECT_EQ(machine->time->jerk, 20000.0);
}

TEST(MachineFile, WrongTurningAxes) {
  const auto codeOf = [](const std::string& text) {
    const auto machine = readMachine(text, "m.toml");
    return machine ? std::string() : std::string(machine.failure().row->code);
  };
  const std::string start = "[turning]\nkinematics = \"table-table\"\n";
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"C\"]\n"), "");
  EXPECT_EQ(codeOf(start), "E0652");
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"A\"]\n"), "E0652");
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"U\"]\n"), "E0652");
  EXPECT_EQ(codeOf(start + "axes = \"AC\"\n"), "E0652");
  EXPECT_EQ(codeOf("[turning]\naxes = [\"A\", \"C\"]\n"), "E0652");
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"C\"]\n[turning.B]\nrange = [0, 1]\n"), "E0651");
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"C\"]\n[turning.A]\nrange = [1, 0]\n"), "E0652");
  EXPECT_EQ(codeOf(start + "axes = [\"A\", \"C\"]\n[turning.A]\ndirection = [0, 0, 1]\n"), "E0652");
  EXPECT_EQ(codeOf("[control]\nunits = \"foot\"\n"), "E0652");
  EXPECT_EQ(codeOf("[control]\nunit = \"mm\"\n"), "E0651");
  EXPECT_EQ(codeOf("[control]\nline_limit = 20\n"), "E0652");
  EXPECT_EQ(codeOf("[time]\njerk = 0\n"), "E0652");
}

}  // namespace
}  // namespace arelem::robot
