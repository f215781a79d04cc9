#include <numbers>

#include "motion_fixture.h"

namespace arelem::test {
namespace {
using ir::Condition;
using ir::Heading;
using P = MotionProgram;

// Stops, relations and directions by plane geometry that a pencil gives.

void expectClean(const MotionProgram& p) {
  for (const Diagnostic& d : p.diagnostics.all()) {
    ADD_FAILURE() << d.message;
  }
}

// A cutter of radius 1 inside a circle of radius 5 touches the wall at x = 5 - 1e-4 nowhere: its
// rim comes as near as 1e-4, which is within the tolerance of 5e-4.
TEST(Condition, TouchWithinTheToleranceStops) {
  const auto inside = P::circle(0, 0, 5);
  const auto wall = P::line(5.0001, -9, 5.0001, 9);
  MotionProgram p;
  p.tolerance(0, 0.0005).cutter({2.0}).from(0, -3.9, 0).go({{inside, Condition::to}});
  p.relation(Word::TLLFT).toward(1, 0, 0);
  p.follow(Heading::forward, inside, Condition::to, wall);
  const auto paths = p.run();
  expectClean(p);
  ASSERT_EQ(paths.size(), 3u);
  expectNear(paths.back().back(), {4, 0, 0}, 1e-9);
}

// With ten times the distance it does not touch, and the motion never stops.
TEST(Condition, NearMissBeyondTheToleranceDoesNotStop) {
  const auto inside = P::circle(0, 0, 5);
  const auto wall = P::line(5.001, -9, 5.001, 9);
  MotionProgram p;
  p.tolerance(0, 0.0005).cutter({2.0}).from(0, -3.9, 0).go({{inside, Condition::to}});
  p.relation(Word::TLLFT).toward(1, 0, 0);
  p.follow(Heading::forward, inside, Condition::to, wall);
  p.run();
  ASSERT_EQ(p.diagnostics.all().size(), 1u);
  EXPECT_EQ(p.diagnostics.all()[0].row->code, "E0508");
}

// The touch is a TO and a PAST at one place: the second TO is at the next crossing.
TEST(Condition, TouchCountsAsTwoPositions) {
  const auto inside = P::circle(0, 0, 5);
  const auto wall = P::line(5.0, -9, 5.0, 9);
  for (const int turn : {1, 2}) {
    MotionProgram p;
    p.tolerance(0, 0.0005).cutter({2.0}).from(0, -3.9, 0).go({{inside, Condition::to}});
    p.relation(Word::TLLFT).toward(1, 0, 0);
    p.follow(Heading::forward, inside, Condition::to, wall, turn);
    const auto paths = p.run();
    expectClean(p);
    ASSERT_EQ(paths.size(), 3u);
    expectNear(paths.back().back(), {4, 0, 0}, 1e-7);
    EXPECT_NEAR(p.outcome.facts.back().length, 4 * std::numbers::pi * (turn - 0.75) * 2, 0.3);
  }
}

// GO/ON, part surface and no TLONPS: the tool end stays on it; TLOFPS says otherwise.
TEST(Condition, PartRelationFollowsTheStartup) {
  const auto part = P::entity(EntityType::cylinder, {0, 0, 0, 1, 0, 0, 10}, "CY");
  const auto drive = P::plane(0, 1, 0, 6);
  const auto end = P::plane(1, 0, 0, 20);
  MotionProgram p;
  p.tolerance(0, 0.001).cutter({1.0}).from(0, 8, 12);
  p.go({{drive, Condition::to}, {part, Condition::on}});
  p.relation(Word::TLLFT).toward(1, 0, 0);
  p.follow(Heading::forward, drive, Condition::on, end);
  const auto paths = p.run();
  expectClean(p);
  const Vec3 last = paths.back().back();
  EXPECT_NEAR(last.y(), 6.5, 1e-9);
  EXPECT_NEAR(std::hypot(last.y(), last.z()), 10.0009, 1e-9);
}

// A forward direction along the tool axis gives way to the last displacement across it.
TEST(Condition, AxialDirectionFallsBackOnTheLastMove) {
  const auto drive = P::line(0, 0, 1, 0);
  const auto end = P::line(9, -5, 9, 5);
  MotionProgram p;
  runtime::Locate step;
  step.word = Word::GOTO;
  step.point = {1, 0, 0};
  p.tolerance(0, 0.001).cutter({1.0}).from(0, 0, 0).add(step).toward(0, 0, -1);
  p.relation(Word::TLON);
  p.follow(Heading::forward, drive, Condition::on, end);
  const auto paths = p.run();
  expectClean(p);
  expectNear(paths.back().back(), {9, 0, 0}, 1e-12);
}

// Seven values with corner radius and center 0: the lines meet in a sharp corner at the diameter.
TEST(Condition, SharpCornerOfSevenValues) {
  const auto wall = P::plane(1, 0, 0, 10);
  const auto slope = P::plane(-1, 0, 1, 0);
  for (const auto& values : {std::vector<double>{2.0}, std::vector<double>{2, 0, 0, 0, 0, 0, 5}}) {
    MotionProgram p;
    p.tolerance(0, 0.001).cutter(values).from(0, 0, 9);
    p.go({{wall, Condition::to}, {slope, Condition::to}});
    const auto paths = p.run();
    expectClean(p);
    expectNear(paths.back().back(), {9, 0, 10}, 1e-12);
  }
}

// TLAXIS/NORMPS from an upright tool: the tool turns about its end first, in one cut vector where
// the first one along the path cannot take the turn in.
TEST(Condition, ToolTurnsToTheNormalFirst) {
  const auto part = P::entity(EntityType::cylinder, {0, 0, 0, 1, 0, 0, 10}, "CY");
  const auto drive = P::plane(1, 0, 0, 0);
  const auto end = P::plane(0, 1, 0, 8);
  MotionProgram p;
  p.tolerance(0, 0.001).cutter({1.0}).from(0, 6, 12).add(runtime::Toggle{Word::MULTAX, true});
  p.go({{drive, Condition::on}, {part, Condition::on}, {P::plane(0, 1, 0, 6), Condition::on}});
  p.relation(Word::TLONPS).relation(Word::TLON).toward(0, 1, 0);
  runtime::ToolAxis axis;
  axis.kind = runtime::ToolAxis::Kind::normalPart;
  p.add(axis);
  p.follow(Heading::forward, drive, Condition::on, end);
  const auto paths = p.run();
  expectClean(p);
  const Vec3 last = paths.back().back();
  const double z = std::sqrt(10.0009 * 10.0009 - 64.0);
  expectNear(last, {0, 8, z}, 1e-9);
  expectNear(p.axes.back(), Vec3(0, 8, z).normalized(), 1e-9);
}

}  // namespace
}  // namespace arelem::test
