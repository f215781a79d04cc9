// Angles of G97 blocks: the source's cases with the printed and the right values, and all octants.
#include "backend/g97/pose.h"

#include <cmath>
#include <fstream>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "backend/g97/block.h"

namespace arelem::g97 {
namespace {

using Json = nlohmann::json;

std::vector<Json> casesOf(const std::string& function) {
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/golden/cases_sen.json");
  std::vector<Json> list;
  for (Json& one : Json::parse(in).get<std::vector<Json>>()) {
    if (one.value("fn", "") == function) {
      list.push_back(std::move(one));
    }
  }
  return list;
}

double degreesOff(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

robot::Pose poseOf(const Vec3& axis) {
  return {Vec3(1, 2, 3), axis, std::nullopt};
}

TEST(G97Angles, OfTheSource) {
  robot::G97Style upright;
  upright.uprightRoll = true;
  for (const Json& one : casesOf("fn_sen.pqr")) {
    const std::vector<double> n = one.at("inputs").at("n");
    const Vec3 axis = Vec3(n[0], n[1], n[2]).normalized();
    const Json& expected = one.at("expected");
    const Angles right = anglesOf(upright, poseOf(axis));
    EXPECT_NEAR(right.p, expected.at("P").get<double>(), 1e-9) << one.at("id");
    EXPECT_NEAR(right.q, expected.at("Q").get<double>(), 1e-9) << one.at("id");
    EXPECT_NEAR(right.r, expected.at("R").get<double>(), 1e-9) << one.at("id");
    EXPECT_EQ(anglesOf({}, poseOf(axis)).r, 0.0);
    const Angles printed = robopaintAngles(axis);
    EXPECT_NEAR(printed.p, expected.at("sen_P").get<double>(), 1e-9) << one.at("id");
    EXPECT_NEAR(printed.q, expected.at("sen_Q").get<double>(), 1e-9) << one.at("id");
    EXPECT_NEAR(degreesOff(matrixOf({}, printed).col(2), axis),
                expected.at("sen_axis_error").get<double>(), 1e-5)
        << one.at("id");
  }
}

TEST(G97Angles, AxesOfTheExampleBlock) {
  const Json one = casesOf("fn_sen.axis_from_pqr").at(0);
  const robot::Matrix3 m = matrixOf({}, {30.0, 25.0, 0.0});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(m(i, 2), one.at("expected").at("Z")[i].get<double>(), 1e-12);
    EXPECT_NEAR(m(i, 0), one.at("expected").at("X")[i].get<double>(), 1e-12);
  }
}

TEST(G97Angles, PointTheGunAlongTheAxisInEveryOctant) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const bool fixed : {false, true}) {
    robot::G97Style style;
    style.fixedAxes = fixed;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
      const Vec3 side =
          axis.cross(Vec3(normal(random), normal(random), normal(random))).normalized();
      const Angles plain = anglesOf(style, poseOf(axis));
      EXPECT_LT(degreesOff(matrixOf(style, plain).col(2), axis), 1e-9);
      EXPECT_LE(std::abs(plain.q), 90.0);
      const Angles turned = anglesOf(style, {Vec3::Zero(), axis, side});
      const robot::Matrix3 m = matrixOf(style, turned);
      EXPECT_LT(degreesOff(m.col(2), axis), 1e-9);
      EXPECT_LT(degreesOff(m.col(0), side), 1e-9);
      EXPECT_LE(std::abs(turned.q), 90.0);
    }
  }
}

TEST(G97Angles, AlongTheCoordinateAxesWithASide) {
  for (const bool fixed : {false, true}) {
    robot::G97Style style;
    style.fixedAxes = fixed;
    for (int i = 0; i < 3; ++i) {
      for (const double sign : {1.0, -1.0}) {
        for (const int k : {(i + 1) % 3, (i + 2) % 3}) {
          const Vec3 axis = sign * Vec3::Unit(i);
          const Vec3 side = -sign * Vec3::Unit(k);
          const robot::Matrix3 m = matrixOf(style, anglesOf(style, {Vec3::Zero(), axis, side}));
          EXPECT_LT(degreesOff(m.col(2), axis), 1e-9) << i << sign << k;
          EXPECT_LT(degreesOff(m.col(0), side), 1e-9) << i << sign << k;
        }
      }
    }
  }
}

TEST(G97Blocks, GoThereAndBackWithToolAndFrame) {
  robot::Machine machine;
  machine.frame.shift = {700, -20, 200};
  machine.frame.angles = {-90, 0, 0};
  machine.g97.inBase = true;
  machine.g97.tool = {0, 0, -150};
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const robot::Pose pose = {Vec3(normal(random), normal(random), normal(random)) * 100.0,
                              Vec3(normal(random), normal(random), normal(random)).normalized(),
                              std::nullopt};
    const Result<BlockPose> block = blockOf(machine, pose, "here");
    ASSERT_TRUE(block.ok());
    const robot::Pose again = g97::poseOf(machine, *block);
    EXPECT_LT((again.point - pose.point).norm(), 0.01 + 150.0 * 0.0002);
    EXPECT_LT(degreesOff(again.axis, pose.axis), 0.01);
  }
  // 90 degrees clockwise: the work's x is the base's -y. The taught point is 150 below the nozzle.
  const Result<BlockPose> one = blockOf(machine, {Vec3(10, 0, 0), Vec3::UnitZ(), std::nullopt}, "");
  EXPECT_LT((one->point - Vec3(700, -30, 350)).norm(), 1e-9);
}

TEST(G97Blocks, ThePrintedExample) {
  const Json one = casesOf("fn_sen.block").at(0);
  Block block;
  block.straight = true;
  block.speed = 100;
  block.pose = {Vec3(400, 350, 200), {30, 25, 0}};
  block.code = "RON,1";
  std::string wanted;
  for (const Json& line : one.at("published").at("text")) {
    wanted += line.get<std::string>() + "\r\n";
  }
  const std::string text = textOf({Program{0, {block, block}}}, {});
  EXPECT_EQ(text.substr(0, wanted.size()), wanted);
}

}  // namespace
}  // namespace arelem::g97
