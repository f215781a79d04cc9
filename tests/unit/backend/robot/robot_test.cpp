#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "backend/robot/machine.h"
#include "backend/robot/reach.h"
#include "backend/robot/reach_check.h"

namespace arelem::robot {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  auto read = readMachine(text, "x.toml");
  EXPECT_FALSE(read.ok()) << text;
  return read.ok() ? "" : std::string(read.failure().row->code) + " " + read.failure().message;
}

TEST(MachineFile, ReadsWhatItIsTold) {
  const auto read = readMachine(
      "name = \"M\"\nspeed = 900\n[scara]\nlink1 = 500\njoint1 = [-10, 20]\n"
      "[tilt]\ncoding = \"twos-complement\"\n[vplus]\nsignal = \"fly\"\n",
      "x.toml");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->name, "M");
  EXPECT_EQ(read->speed, 900.0);
  EXPECT_EQ(read->scara->link1, 500.0);
  EXPECT_EQ(read->scara->link2, 508.0);
  EXPECT_EQ(read->scara->joint1.high, 20.0);
  EXPECT_FALSE(read->tilt->signMagnitude);
  EXPECT_TRUE(read->vplus.onTheFly);
  EXPECT_FALSE(read->elbow.has_value());
}

TEST(MachineFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(refusal("speed = = 3"), HasSubstr("E0650 `x.toml`, line 1"));
  EXPECT_THAT(refusal("\nspede = 3"), HasSubstr("E0651 `x.toml`, line 2: there is no key `spede`"));
  EXPECT_THAT(refusal("[scara]\nlink3 = 3"), HasSubstr("`scara.link3`"));
  EXPECT_THAT(refusal("speed = \"fast\""),
              HasSubstr("E0652 `x.toml`, line 1: `speed` must be a number"));
  EXPECT_THAT(refusal("speed = -1"), HasSubstr("E0652"));
  EXPECT_THAT(refusal("speed = nan"), HasSubstr("E0652"));
  EXPECT_THAT(refusal("[scara]\njoint1 = [5, -5]"), HasSubstr("the smaller first"));
  EXPECT_THAT(refusal("[vplus]\nsignal = \"late\""), HasSubstr("one of \"stop\", \"fly\""));
  EXPECT_THAT(refusal("scara = 3"), HasSubstr("must be a table [scara]"));
}

TEST(MachineFile, ShippedOnesAreGood) {
  for (const std::string name :
       {"adept_three", "elbow_robot", "g97_painter", "mill3", "mill5_head_head", "mill5_head_table",
        "mill5_table_table", "path_b", "path_s", "stencil_robot"}) {
    std::ifstream in(ARELEM_SOURCE_DIR "/stdlib/machines/" + name + ".machine.toml");
    std::stringstream text;
    text << in.rdbuf();
    const auto read = readMachine(text.str(), name);
    EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.failure().message);
  }
}

/// Blank's table 2.2 is sign and magnitude; his text says two's complement. Cases BLANK-zworld.
TEST(Tilt, WordsOfTheSource) {
  TiltAxis table;
  EXPECT_EQ(tiltWord(table, 0.2), 1);
  EXPECT_EQ(tiltWord(table, 25.4), 127);
  EXPECT_EQ(tiltWord(table, -25.4), 255);
  EXPECT_NEAR(tiltAngle(table, 255), -25.4, 1e-12);
  TiltAxis text;
  text.signMagnitude = false;
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/stencil/cases_blank.json");
  int cases = 0;
  for (const auto& one : nlohmann::json::parse(in)) {
    if (one["id"].get<std::string>().starts_with("BLANK-zworld")) {
      EXPECT_NEAR(tiltAngle(text, one["inputs"]["byte"]), one["expected"]["deg"], 1e-6);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 4);
  for (int word = 0; word < 256; ++word) {
    EXPECT_NEAR(tiltAngle(text, tiltWord(text, tiltAngle(text, word))), tiltAngle(text, word),
                1e-12);
  }
}

TEST(Euler, ToolStraightDownTakesItsHeadingAsRoll) {
  for (const double heading : {0.0, 30.0, 135.0, -90.0}) {
    const double a = heading * std::numbers::pi / 180.0;
    const Pose pose{Vec3::Zero(), Vec3::UnitZ(), Vec3(std::cos(a), std::sin(a), 0.0)};
    const Euler e = eulerOf(toolFrame(pose));
    EXPECT_NEAR(e.yaw, 0.0, 1e-9);
    EXPECT_NEAR(e.pitch, 180.0, 1e-9);
    EXPECT_NEAR(std::remainder(e.roll - (180.0 - heading), 360.0), 0.0, 1e-9);
  }
}

/// A round tool: pitch and yaw follow from the axis, roll is 0.
TEST(Euler, AxisWithoutSide) {
  const Euler level = eulerOf(toolFrame({Vec3::Zero(), Vec3::UnitX(), std::nullopt}));
  EXPECT_NEAR(level.pitch, 90.0, 1e-9);
  EXPECT_NEAR(std::abs(level.yaw), 180.0, 1e-9);
  EXPECT_NEAR(level.roll, 0.0, 1e-9);
}

TEST(Euler, RandomFramesComeBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Quaterniond q(unit(random), unit(random), unit(random), unit(random));
    const Matrix3 frame = q.normalized().toRotationMatrix();
    EXPECT_LT((matrixOf(eulerOf(frame)) - frame).norm(), 1e-12);
    const Pose pose = poseOf(Vec3(1, 2, 3), frame);
    EXPECT_LT((toolFrame(pose) - frame).norm(), 1e-12);
  }
}

TEST(Upright, TiltAlongTheSideIsFoundAndNothingElse) {
  const double b = 15.0 * std::numbers::pi / 180.0;
  // Heading along y, tilted by 15 degrees towards it.
  const auto found = uprightOf(
      {Vec3::Zero(), Vec3(0, std::sin(b), std::cos(b)), Vec3(0, std::cos(b), -std::sin(b))});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->tilt, 15.0, 1e-9);
  EXPECT_NEAR(found->heading, 90.0, 1e-9);
  EXPECT_FALSE(uprightOf({Vec3::Zero(), Vec3(std::sin(b), 0, std::cos(b)), Vec3(0, 1, 0)}));
}

TEST(Scara, JointsLeadBackToThePlace) {
  Scara arm;
  arm.height = {-1000, 1000};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-2.0, 2.0), radius(300.0, 1050.0);
  for (const bool lefty : {false, true}) {
    arm.lefty = lefty;
    for (int i = 0; i < 200; ++i) {
      const double a = angle(random);
      const double r = radius(random);
      const Vec3 place(r * std::cos(a), r * std::sin(a), 5.0);
      const auto objection = objectionToPlace(arm, place, 20.0, 0.0, "here");
      if (objection) {
        EXPECT_EQ(objection->failure.row->code, "E0662");
        continue;
      }
      const ScaraJoints joints = jointsOf(arm, place, 20.0, 0.0);
      EXPECT_LT((pointOf(arm, joints) - place).norm(), 1e-9);
      EXPECT_EQ(joints.joint2 < 0.0, lefty);
      EXPECT_NEAR(std::remainder(joints.joint1 + joints.joint2 + joints.joint4 - 20.0, 360.0), 0.0,
                  1e-9);
    }
  }
}

TEST(Scara, RefusesWithTheMeasure) {
  const Scara arm;
  const auto message = [&](const Vec3& place) {
    const auto objection = objectionToPlace(arm, place, 0.0, 0.0, "location 7");
    EXPECT_TRUE(objection);
    return objection ? objection->failure.message : "";
  };
  // 0.99 of 1067 is 1056.33.
  EXPECT_THAT(
      message({1100, 0, 100}),
      HasSubstr("location 7 at 1100, 0 lies 1100 mm from the axis of the robot, 43.67 mm outside"));
  // Folded to 150 degrees: sqrt(559^2 + 508^2 - 2 559 508 cos 30) = 280.5.
  EXPECT_THAT(message({200, 0, 100}), HasSubstr("mm inside its reach of 280.5"));
  EXPECT_THAT(message({600, 0, 400}),
              HasSubstr("height 400 mm, 95 mm above the highest of the quill"));
  EXPECT_THAT(message({600, 0, -20}), HasSubstr("height -20 mm, 20 mm below the lowest"));
  const auto line = objectionToLine(arm, {500, -500, 0}, {-500, -100, 0}, "location 8");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->failure.row->code, "E0663");
  EXPECT_FALSE(objectionToLine(arm, {500, -300, 0}, {500, 300, 0}, "location 9"));
}

/// 1100, 1200 and 1150 mm are 43.67, 143.67 and 93.67 mm too far.
TEST(ReachCheck, TellsEachKindOnceWithItsWorst) {
  Machine machine;
  machine.scara.emplace();
  ReachCheck check(machine);
  for (const double x : {600.0, 1100.0, 1200.0, 1150.0}) {
    Pose pose;
    pose.point = Vec3(x, 0, x == 600.0 ? 305.5 : 100.0);
    check.begin({});
    check.moveTo(pose, fmt::format("place {:g}", x), false);
    check.moveTo(pose, "again", false);  // counts once
  }
  CollectingSink sink;
  check.report(sink);
  ASSERT_EQ(sink.all().size(), 2U);
  EXPECT_THAT(sink.all()[0].message, HasSubstr("place 600 is at height 305.5 mm, 0.5 mm above"));
  EXPECT_TRUE(sink.all()[0].notes.empty());
  EXPECT_THAT(sink.all()[1].message, HasSubstr("place 1200 at 1200, 0 lies 1200 mm"));
  EXPECT_THAT(sink.all()[1].message, HasSubstr("143.7 mm outside its reach of 1056.33 mm"));
  ASSERT_EQ(sink.all()[1].notes.size(), 1U);
  EXPECT_THAT(sink.all()[1].notes[0], HasSubstr("3 of 4 locations"));
  EXPECT_THAT(sink.all()[1].notes[0], HasSubstr("2, 3, 4"));
}

/// Both ends lie within the range of joint 1, the way between them behind the arm does not.
TEST(Scara, StraightMovesMayNotPassALimit) {
  Scara arm;
  arm.lefty = true;
  const Vec3 from(-100, 800, 100);
  const Vec3 to(-700, -100, 100);
  EXPECT_FALSE(objectionToPlace(arm, from, 140.0, 0.0, "here"));
  EXPECT_FALSE(objectionToPlace(arm, to, -130.0, 0.0, "here"));
  const auto line = objectionToLine(arm, from, to, "location 8");
  ASSERT_TRUE(line);
  EXPECT_EQ(line->failure.row->code, "E0662");
  EXPECT_THAT(line->failure.message, HasSubstr("the straight move to location 8 needs joint 1"));
}

/// A joint of -180 to 180 degrees cannot go on behind its end, though -170 is within its range.
TEST(Scara, StraightMovesMayNotPassHalfATurn) {
  Scara arm;
  arm.joint1 = {-180.0, 180.0};
  const auto along = [&](double low, double high) {
    const auto at = [](double degrees) {
      const double a = degrees * 3.14159265358979 / 180.0;
      return Vec3(800.0 * std::cos(a), 800.0 * std::sin(a), 100.0);
    };
    return objectionToLine(arm, at(low), at(high), "location 2");
  };
  int refused = 0;  // joint 1 passes half a turn on one of 36 steps all around
  for (int i = 0; i < 36; ++i) {
    const auto objection = along(10.0 * i, 10.0 * i + 10.0);
    refused += objection ? 1 : 0;
    EXPECT_TRUE(!objection || objection->failure.row->code == "E0662");
  }
  EXPECT_EQ(refused, 1);
}

/// Seven bits hold 127 steps.
TEST(Machine, TheTiltFitsInItsWord) {
  EXPECT_FALSE(readMachine("[tilt]\nmost = 60\nstep = 0.2\n", "m").ok());
  EXPECT_FALSE(readMachine("[tilt]\nstep = 0.1\n", "m").ok());
  EXPECT_TRUE(readMachine("[tilt]\nmost = 60\nstep = 0.5\n", "m").ok());
}

}  // namespace
}  // namespace arelem::robot
