// Lines on surfaces: numbers of lines, chords, normals, curvature, against closed forms.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/geometry/tabulated_cylinder.h"
#include "runtime/spray/surface/kept.h"
#include "runtime/spray/surface/patch_grid.h"
#include "runtime/spray/surface/radii.h"
#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {
namespace {

Entity entity(EntityType type, std::vector<double> canon) {
  Entity e;
  e.type = type;
  e.canon = std::move(canon);
  return e;
}
Patch patch(const Entity& e, std::optional<Limits4> limits = std::nullopt) {
  Result<Patch> made = patchOf(e, {limits, {}}, 1.0);
  if (!made) {
    ADD_FAILURE() << made.failure().message;
    return {};
  }
  return *made;
}

const Entity cylinder = entity(EntityType::cylinder, {0, 0, 0, 0, 1, 0, 100});
const Entity sphere = entity(EntityType::sphere, {1, 2, 3, 75});
const Entity torus = entity(EntityType::torus, {0, 0, 0, 0, 0, 1, 200, 50});
const Entity cone = entity(EntityType::cone, {0, 0, 0, 0, 0, 1, std::cos(0.5)});

TEST(Patches, NormalsPointOutAndTurnWithRevers) {
  Patch p = patch(sphere);
  for (const auto& [u, v] : {std::pair{10.0, 20.0}, {200.0, -70.0}, {0.0, 90.0}, {360.0, -90.0}}) {
    const Vec3 out = (p.at(u, v) - Vec3(1, 2, 3)).normalized();
    EXPECT_NEAR((p.normal(u, v) - out).norm(), 0.0, 2e-4) << u << ' ' << v;
  }
  p.flipped = true;
  EXPECT_LT(p.normal(10, 20).dot(p.at(10, 20) - Vec3(1, 2, 3)), 0.0);
}

TEST(Patches, AreasAndRadii) {
  const Patch half = patch(cylinder, Limits4{0, 180, 0, 400});
  EXPECT_NEAR(areaOf(half), M_PI * 100 * 400, 20.0);
  Radii radii = smallestRadii(half);
  EXPECT_NEAR(*radii.along, 100.0, 1e-3);
  EXPECT_FALSE(radii.across.has_value());
  radii = smallestRadii(patch(torus));
  EXPECT_NEAR(*radii.across, 50.0, 1e-3);
  EXPECT_NEAR(*radii.along, 150.0, 1e-3);  // at the inner circle; 250 at the outer
  EXPECT_NEAR(*smallestRadii(patch(sphere)).across, 75.0, 1e-3);
  const Patch frustum = patch(cone, Limits4{0, 360, 100, 300});
  EXPECT_NEAR(areaOf(frustum), M_PI * std::sin(0.5) * (90000.0 - 10000.0), 150.0);
}

/// Three chords of a zigzag: no jump where they meet, and each step of u is a step of the place.
TEST(Patches, ACurveGoesOnWhereItsIntervalsMeet) {
  geometry::TabulatedCylinder curve;
  const std::vector<geometry::Vec2> corners = {{-30, 0},  {0, 0},    {100, 0},
                                               {160, 80}, {260, 80}, {290, 80}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    geometry::TabulatedCylinder::Interval& piece = curve.intervals.emplace_back();
    const geometry::Vec2 step = corners[i + 1] - corners[i];
    piece.start = corners[i];
    piece.length = step.norm();
    piece.along = step / piece.length;
    piece.extension = i == 0 || i + 2 == corners.size();
  }
  curve.end = corners.back();
  const Patch p =
      patch(entity(EntityType::tabulatedCylinder, curve.canon()), Limits4{0, 300, 0, 10});
  constexpr double step = 0.05;
  for (double u = 0.0; u + step <= 300.0; u += step) {
    const double way = (p.at(u + step, 0.0) - p.at(u, 0.0)).norm();
    EXPECT_LE(way, step + 1e-9) << u;
    EXPECT_GT(way, 0.8 * step) << u;
  }
  EXPECT_LT((p.at(200.0, 0.0) - Vec3(160, 80, 0)).norm(), 1e-9);
}

Patch between(const Entity& e,
              std::vector<HalfSpace> keep,
              std::optional<Limits4> ranges = std::nullopt) {
  Result<Patch> made = patchOf(e, {ranges, std::move(keep)}, 1.0);
  if (!made) {
    ADD_FAILURE() << made.failure().message;
    return {};
  }
  return *made;
}

TEST(Patches, EndAtPlanes) {
  // Above z = 50 a cylinder of radius 100 along y is 120 degrees wide.
  const std::vector<HalfSpace> ends = {{{0, 1, 0}, 10.0}, {{0, -1, 0}, -310.0}};
  std::vector<HalfSpace> keep = ends;
  keep.push_back({{0, 0, 1}, 50.0});
  const Patch third = between(cylinder, keep);
  EXPECT_NEAR(areaOf(third), 2.0 * M_PI / 3.0 * 100.0 * 300.0, 100.0);
  EXPECT_NEAR(longestWay(third, false), 300.0, 20.0);
  EXPECT_TRUE(third.keeps((third.u0 + third.u1) / 2.0, (third.v0 + third.v1) / 2.0));
  // A slanted end: y above z, so the mean length is what the middle has.
  const Patch slanted = between(cylinder, {{{0, 1, -1}, 0.0}, {{0, -1, 0}, -300.0}});
  EXPECT_NEAR(areaOf(slanted), 2.0 * M_PI * 100.0 * 300.0, 300.0);
  EXPECT_NEAR(slanted.v0, -100.0, 10.0);
  // A cap of height 25 has the area 2 pi r h; a frustum between heights as one between v.
  EXPECT_NEAR(areaOf(between(sphere, {{{0, 0, 1}, 3.0 + 50.0}})), 2.0 * M_PI * 75.0 * 25.0, 60.0);
  const double c = std::cos(0.5);
  EXPECT_NEAR(areaOf(between(cone, {{{0, 0, 1}, 100.0 * c}, {{0, 0, -1}, -300.0 * c}})),
              M_PI * std::sin(0.5) * (90000.0 - 10000.0), 200.0);
  // A triangle of a plane.
  const Entity plane = entity(EntityType::plane, {0, 0, 1, 5});
  EXPECT_NEAR(areaOf(between(plane, {{{1, 0, 0}, 0.0}, {{0, 1, 0}, 0.0}, {{-3, -4, 0}, -1200.0}})),
              0.5 * 400.0 * 300.0, 60.0);
}

TEST(Patches, PlanesMustCutThemOffAndLeaveSomething) {
  const auto message = [](const Entity& e, std::vector<HalfSpace> keep) {
    const Result<Patch> made = patchOf(e, {std::nullopt, std::move(keep)}, 1.0);
    return made ? std::string() : made.failure().message;
  };
  const Entity plane = entity(EntityType::plane, {0, 0, 1, 5});
  EXPECT_NE(message(cylinder, {{{0, 1, 0}, 0.0}}).find("no end between the planes"),
            std::string::npos);
  EXPECT_NE(message(plane, {{{1, 0, 0}, 0.0}, {{-1, 0, 0}, -9.0}}).find("no end"),
            std::string::npos);
  for (const Entity& e : {cylinder, plane}) {
    EXPECT_NE(message(e, {{{0, 1, 0}, 5.0}, {{0, -1, 0}, 5.0}}).find("nothing left"),
              std::string::npos);
  }
  EXPECT_NE(message(sphere, {{{0, 0, 1}, 500.0}}).find("nothing left"), std::string::npos);
}

TEST(Lines, EndAtPlanesOnTheSurface) {
  const Patch cap = between(sphere, {{{1, 0, 0}, 21.0}});
  const LineSet set = linesOn(cap, {true, 10.0, 0.1});
  std::size_t ends = 0;
  for (const SurfaceLine& line : set.lines) {
    for (const SurfaceLine& piece : keptPieces(cap, line)) {
      for (const LinePoint& p : piece) {
        EXPECT_NEAR((p.place - Vec3(1, 2, 3)).norm(), 75.0, 1e-9);
        EXPECT_GE(p.place.x(), 21.0 - 1e-9);
      }
      for (const LinePoint& p : {piece.front(), piece.back()}) {
        EXPECT_NEAR(p.place.x(), 21.0, 1e-6);
        ++ends;
      }
    }
  }
  EXPECT_GT(ends, 20U);
}

/// Two triangles of a square, cut along its diagonal the other way and across: areas by pencil.
TEST(Lines, MeshesAreCutByPlanes) {
  geometry::TriangleMesh square;
  square.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto areaAndOpen = [&](const std::vector<HalfSpace>& keep) {
    const MeshSurface cut = MeshSurface(square, false).cutBy(keep);
    return std::pair{cut.area(), geometry::openEdges(cut.mesh())};
  };
  EXPECT_NEAR(areaAndOpen({{{1, 0, 0}, 4.0}}).first, 60.0, 1e-9);
  EXPECT_NEAR(areaAndOpen({{{-1, -1, 0}, -10.0}}).first, 50.0, 1e-9);
  EXPECT_NEAR(areaAndOpen({{{1, 0, 0}, 4.0}, {{0, -1, 0}, -5.0}}).first, 30.0, 1e-9);
  EXPECT_EQ(areaAndOpen({{{1, 0, 0}, 4.0}}).second, 5U);  // one of the sides is cut in two
  EXPECT_TRUE(MeshSurface(square, false).cutBy({{{1, 0, 0}, 11.0}}).mesh().triangles.empty());
}

/// A roof of two slopes, cut near its ridge: the normals along a section change as before.
TEST(Lines, CutsDoNotBendAMesh) {
  geometry::TriangleMesh roof;
  roof.vertices = {{-10, 0, 0}, {0, 0, 1}, {10, 0, 0}, {-10, 10, 0}, {0, 10, 1}, {10, 10, 0}};
  roof.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  const MeshSurface whole(roof, false);
  const MeshSurface cut = whole.cutBy({{{-1, 0, 0}, -0.01}});  // little of the right slope
  const CuttingPlane plane = {{0, 1, 0}, 5.0, std::nullopt, Vec3::Zero()};
  const std::vector<SurfaceLine> lines = cut.sections({plane}, 1e-6);
  ASSERT_EQ(lines.size(), 1U);
  const LinePoint& end = lines[0].front().place.x() > 0.0 ? lines[0].front() : lines[0].back();
  EXPECT_NEAR(end.place.x(), 0.01, 1e-9);
  EXPECT_LT((end.normal - Vec3::UnitZ()).norm(), 1e-3);  // at the ridge it points up
}

TEST(Patches, LimitsAreChecked) {
  const auto code = [](const Entity& e, std::optional<Limits4> limits) {
    const Result<Patch> made = patchOf(e, {limits, {}}, 1.0);
    return made ? std::string() : std::string(made.failure().row->code);
  };
  EXPECT_EQ(code(cylinder, std::nullopt), "E0377");
  EXPECT_EQ(code(cylinder, Limits4{0, 180, 10, 0}), "E0377");
  EXPECT_EQ(code(cylinder, Limits4{0, 361, 0, 10}), "E0377");
  EXPECT_EQ(code(sphere, Limits4{0, 90, -91, 0}), "E0377");
  EXPECT_EQ(code(cone, Limits4{0, 90, -10, 10}), "E0377");
  EXPECT_EQ(code(entity(EntityType::point, {0, 0, 0}), std::nullopt), "E0378");
}

TEST(SurfaceLines, HalfACylinderAsTheSource) {
  const Patch half = patch(cylinder, Limits4{0, 180, 0, 400});
  const LineSet along = linesOn(half, {false, 20.23, 0.5});
  EXPECT_EQ(along.count.intervals, 16);
  EXPECT_EQ(along.lines.size(), 17U);
  EXPECT_NEAR(along.count.step, 19.634954084936208, 1e-6);
  for (std::size_t i = 0; i < along.lines.size(); ++i) {
    ASSERT_EQ(along.lines[i].size(), 2U);  // straight lines need no points between
    EXPECT_EQ(along.lines[i].front().place.y() < along.lines[i].back().place.y(), i % 2 == 0);
  }
  const LineSet round = linesOn(half, {true, 20.23, 0.5});
  EXPECT_EQ(round.lines.size(), 21U);  // 400 / 20.23 = 19.8
  for (const SurfaceLine& line : round.lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec3 middle = (line[i].place + line[i - 1].place) / 2.0;
      EXPECT_GT(std::hypot(middle.x(), middle.z()), 100.0 - 0.5);
      EXPECT_NEAR(std::hypot(line[i].place.x(), line[i].place.z()), 100.0, 1e-9);
    }
  }
}

TEST(SurfaceLines, AWholeTurnHasNoDoubleLine) {
  const LineSet set = linesOn(patch(cylinder, Limits4{0, 360, 0, 400}), {false, 50.0, 0.5});
  EXPECT_EQ(set.lines.size(), static_cast<std::size_t>(set.count.intervals));
}

TEST(SurfaceLines, SectionsLieInTheirPlanes) {
  const Patch p = patch(sphere, Limits4{0, 180, -80, 80});
  const Result<PatchGrid> grid = PatchGrid::of(p, 0.05);
  ASSERT_TRUE(grid.ok());
  for (const double level : {-40.0, 0.0, 33.0}) {
    const auto sections = sectionOf(p, *grid, {Vec3::UnitX(), level + 1.0, {}, {}}, 0.05);
    ASSERT_EQ(sections.size(), 1U);
    for (const LinePoint& q : sections.front()) {
      EXPECT_NEAR(q.place.x() - 1.0, level, 1e-6);
      EXPECT_NEAR((q.place - Vec3(1, 2, 3)).norm(), 75.0, 1e-9);
    }
  }
}

TEST(SurfaceLines, RadiiAtTheRimCount) {
  // A cone of half angle 45 degrees from 100 to 101 mm of its side: the radius of curvature along
  // u is what the side is long, at the smaller rim 100.
  Patch p;
  p.at = [](double u, double v) {
    const double t = u * std::numbers::pi / 180.0;
    const double r = v * std::sqrt(0.5);
    return Vec3(r * std::cos(t), r * std::sin(t), r);
  };
  p.u1 = 90.0;
  p.v0 = 100.0;
  p.v1 = 400.0;
  ASSERT_TRUE(smallestRadii(p).along.has_value());
  EXPECT_NEAR(*smallestRadii(p).along, 100.0, 0.4);
}

SurfaceJob job(Patch p) {
  SurfaceJob j;
  j.patch = std::move(p);
  j.gun.kind = Gun::Kind::cone;
  j.gun.footprint = {20.0, 20.0};
  j.gun.standOff = 150.0;
  j.gun.angle = std::atan(20.0 / 150.0);
  j.gun.flow = 20.3 * milliliterPerMinute;
  j.gun.efficiency = 0.45;
  j.film = 0.12;
  return j;
}

TEST(SurfaceJobs, SpeedFollowsFromTheFlow) {
  const Result<Sprayed> s = spraySurface(job(patch(cylinder, Limits4{0, 180, 0, 400})));
  ASSERT_TRUE(s.ok()) << s.failure().message;
  EXPECT_NEAR(s->chosen.operation.speed, speedFor(20.3 * milliliterPerMinute, 0.45, 0.12, s->step),
              1e-9);
}

TEST(SurfaceJobs, TheNozzleKeepsTheLargestSpeed) {
  // Round a cylinder of 100 with the nozzle 150 off it: the nozzle goes 2.5 times as fast.
  SurfaceJob round = job(patch(cylinder, Limits4{0, 180, 0, 400}));
  round.gun.flow = 0.0;
  round.gun.speed = 500.0;
  const Result<Sprayed> s = spraySurface(round);
  ASSERT_TRUE(s.ok()) << s.failure().message;
  EXPECT_NEAR(s->chosen.operation.speed, 200.0, 1e-6);
  EXPECT_NEAR(s->chosen.operation.flow, 0.12 * s->step * 200.0 / 0.45, 1e-6);
  round.speed = 201.0;
  EXPECT_EQ(spraySurface(round).failure().row->code, "E0373");
  // Along it both go the same way.
  round.lines = SurfaceJob::Way::alongV;
  round.speed = 500.0;
  EXPECT_TRUE(spraySurface(round).ok());
}

TEST(SurfaceJobs, ASurfaceThatBendsTooMuchIsRefused) {
  const Entity thin = entity(EntityType::cylinder, {0, 0, 0, 0, 1, 0, 15});
  SurfaceJob j = job(patch(thin, Limits4{0, 180, 0, 400}));
  const Result<Sprayed> refused = spraySurface(j);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().row->code, "E0379");
  j.checkRadius = false;
  EXPECT_TRUE(spraySurface(j).ok());
}

TEST(SurfaceJobs, TheGunStaysBeforeTheMiddleOfAHollow) {
  SurfaceJob j = job(patch(cylinder, Limits4{0, 360, 0, 400}));  // radius 100, stand-off 150
  EXPECT_TRUE(spraySurface(j).ok());
  j.patch.flipped = true;
  EXPECT_EQ(spraySurface(j).failure().row->code, "E0389");
  j.gun.standOff = 101.0;
  EXPECT_FALSE(spraySurface(j).ok());
  j.gun.standOff = 99.0;
  EXPECT_TRUE(spraySurface(j).ok());
  j.gun.standOff = 150.0;
  j.checkRadius = false;
  EXPECT_TRUE(spraySurface(j).ok());
  // Round the hole of the torus, 150, its outside is hollow; in its tube, 50, the inside is.
  j.checkRadius = true;
  j.patch = patch(torus);
  EXPECT_EQ(spraySurface(j).failure().row->code, "E0389");
  j.gun.standOff = 149.0;
  EXPECT_TRUE(spraySurface(j).ok());
  j.patch.flipped = true;
  EXPECT_FALSE(spraySurface(j).ok());
  j.gun.standOff = 49.0;
  EXPECT_TRUE(spraySurface(j).ok());
}

TEST(SurfaceJobs, TheLinesAtThePolesAreLeftOut) {
  SurfaceJob j = job(patch(sphere));  // half way round 75 pi = 235.6, a line every 20 mm at most
  const Result<Sprayed> whole = spraySurface(j);
  ASSERT_TRUE(whole.ok()) << whole.failure().message;
  EXPECT_EQ(whole->leftOut, 2U);
  EXPECT_EQ(whole->lines, 11U);
  EXPECT_LT(whole->shortest, 1e-2);
  for (const Stroke& stroke : whole->strokes) {
    EXPECT_GT(std::hypot(stroke.from.x() - 1.0, stroke.from.y() - 2.0), 10.0);
  }
  j.lines = SurfaceJob::Way::alongV;
  EXPECT_EQ(spraySurface(j)->leftOut, 0U);
  // Planes through an axis leave points where it meets the surface: no lines that anyone asked for.
  j.lines = SurfaceJob::Radial{{25, 0, 0}, Vec3::UnitZ()};
  const Result<Sprayed> radial = spraySurface(j);
  ASSERT_TRUE(radial.ok()) << radial.failure().message;
  EXPECT_EQ(radial->leftOut, 0U);
}

TEST(SurfaceJobs, TheBetterDirectionIsTold) {
  SurfaceJob j = job(patch(cylinder, Limits4{0, 180, 0, 400}));
  j.lines = SurfaceJob::Way::alongU;
  EXPECT_NE(spraySurface(j)->advice.find("VLINES"), std::string::npos);
  j.lines = SurfaceJob::Way::alongV;
  EXPECT_EQ(spraySurface(j)->advice, "");
}

TEST(SurfaceJobs, TheGunMovesFasterWhereLinesAreCloser) {
  // Half angle 0.5: lines to the vertex, whose distance grows with the way from it.
  SurfaceJob job;
  job.patch = patch(cone, Limits4{0, 180, 150, 300});
  job.gun.kind = Gun::Kind::cone;
  job.gun.footprint = {15.0, 15.0};
  job.gun.standOff = 100.0;
  job.gun.flow = 500.0;
  job.film = 0.05;
  job.lines = SurfaceJob::Way::alongV;
  const Result<Sprayed> sprayed = spraySurface(job);
  ASSERT_TRUE(sprayed.ok()) << sprayed.failure().message;
  for (const Stroke& stroke : sprayed->strokes) {
    const double fromVertex = ((stroke.from + stroke.to) / 2.0).norm();
    EXPECT_NEAR(stroke.speed * fromVertex, sprayed->chosen.operation.speed * 300.0,
                0.01 * sprayed->chosen.operation.speed * 300.0);
  }
  job.gun.speed = 1.2 * sprayed->chosen.operation.speed;
  // With a largest speed between: slower at the wide end, so that the film stays even.
  const Result<Sprayed> limited = spraySurface(job);
  ASSERT_TRUE(limited.ok()) << limited.failure().message;
  EXPECT_NEAR(limited->chosen.operation.speed, 0.5 * job.gun.speed, 0.01 * job.gun.speed);
  for (const Stroke& stroke : limited->strokes) {
    EXPECT_LE(stroke.speed, job.gun.speed);
    const double fromVertex = ((stroke.from + stroke.to) / 2.0).norm();
    EXPECT_NEAR(stroke.speed * fromVertex, limited->chosen.operation.speed * 300.0,
                0.01 * limited->chosen.operation.speed * 300.0);
  }
  job.speed = sprayed->chosen.operation.speed;
  const Result<Sprayed> constant = spraySurface(job);
  ASSERT_TRUE(constant.ok()) << constant.failure().message;
  for (const Stroke& stroke : constant->strokes) {
    EXPECT_EQ(stroke.speed, *job.speed);
  }
}

}  // namespace
}  // namespace arelem::spray
