// Sections and lines keep to the chord tolerance on surfaces with many waves.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/spray/surface/patch_grid.h"
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {
namespace {

/// z = 3 sin(waves y), 200 long and wide.
Patch washboard(double waves) {
  Patch p;
  p.at = [waves](double u, double v) { return Vec3(u, v, 3.0 * std::sin(waves * v)); };
  p.u1 = p.v1 = 200.0;
  return p;
}

/// How far the curve z = 3 sin(waves y) lies from the chords of a line along y at most: measured
/// along z, which is more than square to the chord.
double farthestFrom(const SurfaceLine& line, double waves) {
  double farthest = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3& a = line[i - 1].place;
    const Vec3 step = line[i].place - a;
    for (int k = 1; k < 40; ++k) {
      const Vec3 p = a + step * k / 40.0;
      const double off = std::abs(3.0 * std::sin(waves * p.y()) - p.z());
      farthest = std::max(farthest, off * std::abs(step.y()) / step.norm());
    }
  }
  return farthest;
}

TEST(SurfaceLines, SectionsKeepToTheChordTolerance) {
  const double waves = 2.0;  // 64 of them: a grid of 160 steps would have 2.5 a wave
  const Patch p = washboard(waves);
  for (const double chord : {0.5, 0.05}) {
    const Result<PatchGrid> grid = PatchGrid::of(p, chord);
    ASSERT_TRUE(grid.ok());
    const auto sections = sectionOf(p, *grid, {Vec3::UnitX(), 77.7, {}, {}}, chord);
    ASSERT_EQ(sections.size(), 1U);
    EXPECT_NEAR(sections[0].front().place.y() + sections[0].back().place.y(), 200.0, 1e-9);
    EXPECT_LE(farthestFrom(sections[0], waves), 1.1 * chord);
    EXPECT_GE(sections[0].size(), 128U);
  }
  const Result<PatchGrid> refused = PatchGrid::of(washboard(300.0), 0.01);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().row->code, "E0358");
}

TEST(SurfaceLines, AWaveDoesNotLookStraight) {
  // 16 whole waves: what is looked at in 16 equal steps lies on one straight line.
  const double waves = 2.0 * std::numbers::pi * 16.0 / 200.0;
  const LineSet set = linesOn(washboard(waves), {false, 50.0, 0.1});
  ASSERT_EQ(set.lines.size(), 5U);
  EXPECT_LE(farthestFrom(set.lines[0], waves), 0.11);
}

TEST(SurfaceJobs, TooManySectionsAreRefused) {
  SurfaceJob tiny;
  tiny.patch = washboard(0.01);
  tiny.gun.footprint = {0.005, 0.005};
  tiny.gun.speed = 100.0;
  tiny.film = 0.01;
  tiny.lines = SurfaceJob::Parallel{Vec3::UnitX()};
  const Result<Sprayed> refused = spraySurface(tiny);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().row->code, "E0375");
}

}  // namespace
}  // namespace arelem::spray
