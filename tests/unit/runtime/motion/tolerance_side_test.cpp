#include "motion_fixture.h"

namespace arelem::test {
namespace {
using ir::Condition;
using ir::Heading;
using P = MotionProgram;

struct Band {
  double inner, outer;
};

class StartupBand : public testing::TestWithParam<Band> {};

// Startup and motion see the tool end ON a surface from the same side, whatever side it came from:
// a stop of the one is no start outside the band of the other.
TEST_P(StartupBand, OnCircleFromInsideAndOutside) {
  const auto sphere = P::sphere(0, 0, -20, 20);
  const auto circle = P::circle(0, -8, 8);
  const auto start = P::line(-2, -9, -2, 9), end = P::line(2, -9, 2, 9);
  for (const double y : {-3.0, 3.0}) {
    MotionProgram p;
    p.tolerance(GetParam().inner, GetParam().outer).cutter({0.5, 0.25}).from(-4, y, 5);
    p.go({{circle, Condition::on}, {sphere, Condition::to}, {start, Condition::on}});
    p.toward(1, 0, 0).relation(Word::TLON);
    p.follow(Heading::forward, circle, Condition::on, end);
    const auto paths = p.run();
    ASSERT_EQ(p.diagnostics.errors(), 0u) << y << " " << p.diagnostics.all()[0].message;
    // The circle has y = sqrt(60) - 8 at x = 2.
    expectNear(paths.back().back().head<2>().homogeneous(), {2, std::sqrt(60.0) - 8, 1},
               GetParam().inner + GetParam().outer + 1e-6);
  }
}

// A stop ON the check surface is a start ON it as drive surface.
TEST_P(StartupBand, CheckOnBecomesDriveOn) {
  const auto sphere = P::sphere(0, 0, -20, 20);
  const auto line = P::line(-5, 0, 5, 0), start = P::line(-6, -9, -6, 9);
  const auto end = P::line(-9, -1.5, 9, -1.5);
  for (const double x : {8.5, -5.0}) {  // met from outside and from inside
    const auto circle = P::circle(x, 0, 8);
    MotionProgram p;
    p.tolerance(GetParam().inner, GetParam().outer).cutter({0.5, 0.25}).from(-8, 1, 5);
    p.go({{line, Condition::on}, {sphere, Condition::to}, {start, Condition::on}});
    p.toward(1, 0, 0).relation(Word::TLON);
    p.follow(Heading::forward, line, Condition::on, circle);
    p.follow(Heading::right, circle, Condition::on, end);
    const auto paths = p.run();
    ASSERT_EQ(p.diagnostics.errors(), 0u) << x << " " << p.diagnostics.all()[0].message;
    EXPECT_NEAR(paths.back().back().y(), -1.5, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Bands,
                         StartupBand,
                         testing::Values(Band{0, 0.002},
                                         Band{0.002, 0},
                                         Band{0.002, 0.002},
                                         Band{0.001, 0.009},
                                         Band{0.009, 0.001}));

}  // namespace
}  // namespace arelem::test
