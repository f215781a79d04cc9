// Arcs of CL files, in all spellings. Expected numbers are those of a pencil.
#include "runtime/motion/arc.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace arelem::motion {
namespace {

runtime::Arc unitArc() {
  runtime::Arc arc;
  arc.axis = Vec3::UnitZ();
  arc.radius = 1.0;
  return arc;
}

TEST(Arc, QuarterTurnHasOnePiece) {
  const auto move = arcMove(unitArc(), {1, 0, 0}, {0, 1, 0}, std::nullopt);
  ASSERT_TRUE(move);
  ASSERT_EQ((*move).pieces.size(), 1U);
  EXPECT_NEAR((*move).length, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(((*move).tangent.normalized() - Vec3(-1, 0, 0)).norm(), 0.0, 1e-12);
}

TEST(Arc, OtherWayRoundIsTheLongWay) {
  runtime::Arc arc = unitArc();
  arc.axis = Vec3(0, 0, -2);  // any length
  const auto move = arcMove(arc, {1, 0, 0}, {0, 1, 0}, std::nullopt);
  ASSERT_TRUE(move);
  EXPECT_NEAR((*move).length, 1.5 * std::numbers::pi, 1e-12);
}

TEST(Arc, EndAtTheStartIsAWholeTurn) {
  const auto move = arcMove(unitArc(), {1, 0, 0}, {1, 0, 0}, std::nullopt);
  ASSERT_TRUE(move);
  EXPECT_NEAR((*move).length, 2 * std::numbers::pi, 1e-12);
}

TEST(Arc, WholeTurnsOfAHelixArePieces) {
  runtime::Arc arc = unitArc();
  arc.turns = 2;
  const auto move = arcMove(arc, {1, 0, 0}, {0, 1, 9}, std::nullopt);
  ASSERT_TRUE(move);
  ASSERT_EQ((*move).pieces.size(), 3U);  // 2.25 turns rise by 9: 4 a turn
  EXPECT_NEAR(((*move).pieces[0].end - Vec3(1, 0, 4)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(((*move).pieces[1].end - Vec3(1, 0, 8)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(((*move).pieces[2].end - Vec3(0, 1, 9)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((*move).length, std::hypot(4.5 * std::numbers::pi, 9.0), 1e-12);
}

TEST(Arc, StatedAngleTellsTheTurns) {
  runtime::Arc arc = unitArc();
  arc.sweepDegrees = 450.0;
  const auto move = arcMove(arc, {1, 0, 0}, {0, 1, 0}, std::nullopt);
  ASSERT_TRUE(move);
  EXPECT_EQ((*move).pieces.size(), 2U);
  EXPECT_TRUE((*move).warnings.empty());
  arc.sweepDegrees = 80.0;
  const auto wrong = arcMove(arc, {1, 0, 0}, {0, 1, 0}, std::nullopt);
  ASSERT_TRUE(wrong);
  EXPECT_EQ((*wrong).warnings.size(), 1U);
}

TEST(Arc, PlaneFromTheDirectionAtTheStart) {
  runtime::Arc arc;
  arc.center = {0, 39.9, 199.9};
  arc.radius = 1.2;
  const auto move = arcMove(arc, {0, 39.9, 201.1}, {0, 41.1, 199.9}, Vec3(0, 1, 0));
  ASSERT_TRUE(move);
  EXPECT_NEAR((*move).length, 0.6 * std::numbers::pi, 1e-12);  // a quarter, in the YZ plane
}

TEST(Arc, CenterAtAnyHeightOfItsAxis) {
  runtime::Arc arc = unitArc();
  arc.center = {0, 0, 77};
  const auto move = arcMove(arc, {1, 0, 2}, {0, 1, 3}, std::nullopt);
  ASSERT_TRUE(move);
  EXPECT_DOUBLE_EQ((*move).pieces[0].circle.surface.canon[2], 2.0);
}

TEST(Arc, EndsOffTheCircle) {
  const auto warned = arcMove(unitArc(), {1, 0, 0}, {0, 1.001, 0}, std::nullopt);
  ASSERT_TRUE(warned);
  EXPECT_EQ((*warned).warnings.size(), 1U);
  const auto silent = arcMove(unitArc(), {1, 0, 0}, {0, 1.0002, 0}, std::nullopt);
  ASSERT_TRUE(silent);
  EXPECT_TRUE((*silent).warnings.empty());
  EXPECT_FALSE(arcMove(unitArc(), {1, 0, 0}, {0, 1.5, 0}, std::nullopt));
}

TEST(Arc, RefusesWhatFixesNoPlane) {
  runtime::Arc arc = unitArc();
  arc.axis = Vec3::Zero();
  EXPECT_FALSE(arcMove(arc, {1, 0, 0}, {0, 1, 0}, std::nullopt));
  arc.axis.reset();
  EXPECT_FALSE(arcMove(arc, {1, 0, 0}, {0, 1, 0}, std::nullopt));
  EXPECT_FALSE(arcMove(arc, {1, 0, 0}, {0, 1, 0}, Vec3(1, 0, 0)));
}

}  // namespace
}  // namespace arelem::motion
