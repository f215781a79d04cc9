// Angles of G97 blocks: the source's cases with the printed and the right values, and all octants.
#include "backend/g97/pose.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "backend/g97/block.h"

namespace arelem::g97 {
namespace {

using Json = nlohmann::json;

/// The rows that speak of angles and blocks; runtime/spray tests the others.
std::vector<Json> rows() {
  std::ifstream in(ARELEM_SOURCE_DIR "/tests/data/golden/cases_sen.json");
  std::vector<Json> list;
  for (Json& one : Json::parse(in).get<std::vector<Json>>()) {
    const std::string function = one.value("fn", "");
    if (function == "fn_sen.pqr" || function == "fn_sen.axis_from_pqr" ||
        function == "fn_sen.block") {
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

class SenAngles : public testing::TestWithParam<Json> {
 protected:
  [[nodiscard]] const Json& expected() const { return GetParam().at("expected"); }
  [[nodiscard]] double wanted(const char* key) const { return expected().at(key).get<double>(); }
  void angles() const;
  void axes() const;
  void block() const;
};

/// The right angles, and the printed ones with how far they miss the axis.
void SenAngles::angles() const {
  robot::G97Style upright;
  upright.uprightRoll = true;
  const std::vector<double> n = GetParam().at("inputs").at("n");
  const Vec3 axis = Vec3(n[0], n[1], n[2]).normalized();
  const Angles right = anglesOf(upright, poseOf(axis));
  EXPECT_NEAR(right.p, wanted("P"), 1e-9);
  EXPECT_NEAR(right.q, wanted("Q"), 1e-9);
  EXPECT_NEAR(right.r, wanted("R"), 1e-9);
  EXPECT_NEAR(degreesOff(matrixOf({}, right).col(2), axis), wanted("axis_error"), 1e-5);
  EXPECT_EQ(anglesOf({}, poseOf(axis)).r, 0.0);
  const Angles printed = robopaintAngles(axis);
  EXPECT_NEAR(printed.p, wanted("sen_P"), 1e-9);
  EXPECT_NEAR(printed.q, wanted("sen_Q"), 1e-9);
  const double off = degreesOff(matrixOf({}, printed).col(2), axis);
  EXPECT_NEAR(off, wanted("sen_axis_error"), 1e-5);
  // Equation (13), which the source gives up for R = 0.
  EXPECT_NEAR(axis.x() == 0.0 && axis.y() == 0.0
                  ? 0.0
                  : std::atan2(axis.y(), axis.x()) * 180.0 / std::numbers::pi,
              wanted("sen_R"), 1e-9);
}

void SenAngles::axes() const {
  const Json& in = GetParam().at("inputs");
  const robot::Matrix3 m =
      matrixOf({}, {in.at("P").get<double>(), in.at("Q").get<double>(), in.at("R").get<double>()});
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(m(i, 2), expected().at("Z")[i].get<double>(), 1e-12);
    EXPECT_NEAR(m(i, 0), expected().at("X")[i].get<double>(), 1e-12);
  }
}

void SenAngles::block() const {
  const Json& in = GetParam().at("inputs");
  const auto number = [&in](const char* key) { return in.at(key).get<double>(); };
  Block block;
  block.straight = true;
  block.speed = in.at("f").get<int>();
  block.pose = {Vec3(number("x"), number("y"), number("z")),
                {number("p"), number("q"), number("r")}};
  block.code = "RON,1";
  std::string lines;
  for (const Json& line : GetParam().at("published").at("text")) {
    lines += line.get<std::string>() + "\r\n";
  }
  const std::string text = textOf({Program{0, {block, block}}}, {});
  EXPECT_EQ(text.substr(0, lines.size()), lines);
  EXPECT_EQ(GetParam().at("published").at("text"), expected().at("text"));
}

TEST_P(SenAngles, GivesTheNumbers) {
  const std::string function = GetParam().at("fn");
  function == "fn_sen.pqr" ? angles() : function == "fn_sen.block" ? block() : axes();
}

INSTANTIATE_TEST_SUITE_P(Golden, SenAngles, testing::ValuesIn(rows()), [](const auto& one) {
  std::string name = one.param.at("id");
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
});

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

TEST(G97Angles, OfTheSourceKeepTheGunOnItsSideInEveryOctant) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        const Vec3 axis = Vec3(x, y, z).normalized();
        // atan(1 / sqrt 2) and 45 degrees differ by 9.7356 degrees.
        EXPECT_NEAR(degreesOff(matrixOf({}, robopaintAngles(axis)).col(2), axis), 9.7356, 1e-4);
      }
    }
  }
  // What rounding leaves of c at the edge of a half cylinder turns nothing over.
  EXPECT_EQ(robopaintAngles(Vec3(1, 0, -1e-17)).p, 0.0);
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

}  // namespace
}  // namespace arelem::g97
