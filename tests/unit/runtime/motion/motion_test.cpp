#include "motion_fixture.h"

namespace arelem::test {
namespace {
using ir::Condition;
using ir::Heading;
using P = MotionProgram;

// The values are those of the old system's runs c06, d01 and of plane geometry.

TEST(Motion, ObroundByTangentStops) {
  const auto c1 = P::circle(2.15, 3.25, 1.35);
  const auto c2 = P::circle(7.45, 4.15, 0.95);
  const auto top =
      P::line(1.883, 4.573, 7.263, 5.081);  // not used as drive: only the fixture's shape
  (void)top;
  MotionProgram p;
  // Two unit circles on the x axis joined by y = 1 and y = -1.
  const auto a = P::circle(0, 0, 1);
  const auto b = P::circle(10, 0, 1);
  const auto up = P::line(0, 1, 10, 1);
  const auto down = P::line(0, -1, 10, -1);
  p.tolerance(0, 0.001).cutter({0.5}).from(5, 5, 0).go({{up, Condition::to}});
  p.relation(Word::TLRGT);
  p.follow(Heading::right, up, Condition::tanto, a);
  p.follow(Heading::forward, a, Condition::tanto, down);
  p.follow(Heading::forward, down, Condition::tanto, b);
  p.follow(Heading::forward, b, Condition::tanto, up);
  const auto paths = p.run();
  for (const auto& d : p.diagnostics.all())
    ADD_FAILURE() << d.message;
  ASSERT_EQ(paths.size(), 6u);
  expectNear(paths[1].back(), {5, 1.25, 0}, 1e-12);
  expectNear(paths[2].back(), {0, 1.25, 0}, 1e-12);
  expectNear(paths[3].back(), {0, -1.25, 0}, 1e-12);
  expectNear(paths[4].back(), {10, -1.25, 0}, 1e-12);
  expectNear(paths[5].back(), {10, 1.25, 0}, 1e-12);
  // Half a turn on radius 1.25 with the band [0, 0.001]: a half step of acos(1.25/1.251).
  const double halfSteps = std::floor(M_PI / std::acos(1.25 / 1.251)) + 1;
  EXPECT_EQ(paths[3].size(), static_cast<std::size_t>(std::ceil(halfSteps / 2)) + 1);
  for (std::size_t i = 0; i + 1 < paths[3].size(); ++i) {
    EXPECT_NEAR(paths[3][i].norm(), 1.251, 1e-12);
  }
}

TEST(Motion, TangencyIsNotPassedByAtAnyTolerance) {
  // A quarter turn from one tangent line to the next, whatever way the cut vectors fall.
  const auto right = P::line(50, 50, 50, -20), below = P::line(-50, -50, 50, -50);
  const auto circle = P::circle(20, -20, 30);
  for (const double tolerance :
       {0.05, 0.01, 0.003, 0.001, 0.0007, 0.0005, 0.0003, 0.0002, 0.0001, 0.00005}) {
    for (const double diameter : {20.0, 10.0, 3.0}) {
      MotionProgram p;
      p.tolerance(0, tolerance).cutter({diameter}).from(70, 30, 0).go({{right, Condition::to}});
      p.relation(Word::TLLFT);
      p.follow(Heading::left, right, Condition::tanto, circle);
      p.follow(Heading::forward, circle, Condition::tanto, below);
      const auto paths = p.run();
      ASSERT_EQ(p.diagnostics.errors(), 0u) << p.diagnostics.all()[0].message;
      expectNear(paths.back().back(), {20, -50 - diameter / 2, 0}, 1e-9);
      EXPECT_NEAR(p.outcome.facts.back().length, (30 + diameter / 2) * M_PI / 2, 0.2) << tolerance;
    }
  }
}

TEST(Motion, InsideCorners) {
  const auto l1 = P::line(0.25, 0.35, 7.45, -0.35), l2 = P::line(7.45, -0.35, 8.75, 5.85);
  const auto l3 = P::line(8.75, 5.85, 1.55, 6.15), l4 = P::line(1.55, 6.15, 0.25, 0.35);
  MotionProgram p;
  p.tolerance(0, 0.002)
      .cutter({0.625})
      .from(4.15, 3.35, 0)
      .go({{l1, Condition::to}})
      .relation(Word::TLLFT);
  p.follow(Heading::left, l1, Condition::to, l2).follow(Heading::left, l2, Condition::to, l3);
  p.follow(Heading::left, l3, Condition::to, l4).follow(Heading::left, l4, Condition::to, l1);
  const auto paths = p.run();
  for (const auto& d : p.diagnostics.all())
    ADD_FAILURE() << d.message;
  ASSERT_EQ(paths.size(), 6u);
  for (const auto& path : paths)
    EXPECT_EQ(path.size(), 1u);
}

TEST(Motion, BallOverSphere) {
  const auto ps = P::sphere(0.25, 0.35, -6.5, 8.25);
  const auto x1 = P::line(-4.25, -9, -4.25, 9), x2 = P::line(4.25, -9, 4.25, 9);
  const auto y2 = P::line(-9, 2.15, 9, 2.15);
  const auto ds = P::plane(0.05, 1, 0, 0.45);
  MotionProgram p;
  p.tolerance(0, 0.002).cutter({0.75, 0.375}).from(-8.15, 0.55, 5.25);
  p.go({{ds, Condition::on}, {ps, Condition::to}, {x1, Condition::on}})
      .toward(1, 0, 0)
      .relation(Word::TLON);
  p.follow(Heading::forward, ds, Condition::on, x2).follow(Heading::left, x2, Condition::on, y2);
  const auto paths = p.run();
  for (const auto& d : p.diagnostics.all())
    ADD_FAILURE() << d.message;
  ASSERT_EQ(paths.size(), 4u);
  expectNear(paths[1].back(), {-4.25, 0.6625, 0.478511138}, 2e-4);
  EXPECT_LE(paths[2].size(), 25u);
  expectNear(paths[2].back(), {4.25, 0.2375, 0.76757959}, 2e-4);
  EXPECT_LE(paths[3].size(), 6u);
  expectNear(paths[3].back(), {4.25, 2.15, 0.55343721}, 2e-4);
  for (const Vec3& te : paths[2]) {
    const double gap = (te + Vec3(0, 0, 0.375) - Vec3(0.25, 0.35, -6.5)).norm() - 8.25 - 0.375;
    EXPECT_GE(gap, 0.0);
    EXPECT_LE(gap, 0.002 + 1e-9);
  }
}

TEST(Motion, CheckNeverMet) {
  MotionProgram p;
  const auto l1 = P::line(0, 0, 10, 0);
  p.cutter({0.5}).from(-2, -2, 0).go({{l1, Condition::to}}).relation(Word::TLRGT);
  p.follow(Heading::right, l1, Condition::to, P::line(-5, 0, -5, 5));
  const auto paths = p.run();
  ASSERT_EQ(p.diagnostics.errors(), 1u);
  EXPECT_EQ(p.diagnostics.all()[0].kind().code, "E0508");
  EXPECT_FALSE(p.outcome.complete);
}

}  // namespace
}  // namespace arelem::test
