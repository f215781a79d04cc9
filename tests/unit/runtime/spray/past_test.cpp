// Lines that go on beyond the edges, and guns that would meet the work.
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/film/bursts.h"
#include "runtime/spray/surface/surface_job.h"
#include "runtime/spray/surface/walls.h"
#include "tests/unit/runtime/spray/box_mesh.h"

namespace arelem::spray {
namespace {

Entity entity(EntityType type, std::vector<double> canon) {
  Entity e;
  e.type = type;
  e.canon = std::move(canon);
  return e;
}
const Entity plane = entity(EntityType::plane, {0, 0, 1, 0});
const Entity cylinder = entity(EntityType::cylinder, {0, 0, 0, 0, 1, 0, 200});
const Entity sphere = entity(EntityType::sphere, {0, 0, 0, 300});
const Entity torus = entity(EntityType::torus, {0, 0, 0, 0, 0, 1, 500, 150});

SurfaceJob jobOf(const Entity& e, std::optional<Limits4> limits = std::nullopt) {
  SurfaceJob job;
  job.patch = *patchOf(e, {limits, {}}, 1.0);
  job.gun.footprint = {40.0, 40.0};
  job.gun.standOff = 100.0;
  job.gun.speed = 500.0;
  job.film = 0.05;
  return job;
}

Sprayed sprayed(const SurfaceJob& job) {
  Result<Sprayed> result = spraySurface(job);
  if (!result) {
    ADD_FAILURE() << result.failure().message;
    return {};
  }
  return *std::move(result);
}

/// The places of all strokes, which lie beyond what `inside` says.
template <class Inside>
std::size_t beyond(const Sprayed& s, const Inside& inside) {
  std::size_t count = 0;
  for (const Stroke& stroke : s.strokes) {
    count += (inside(stroke.from) ? 0U : 1U) + (inside(stroke.to) ? 0U : 1U);
  }
  return count;
}

/// A plate of 400 by 300, lines 20 apart where the footprint is 80 wide: places at the ends are
/// sprayed half as long, those on the sides lack a pass.
TEST(Past, EdgesGetTheFilmOfTheMiddle) {
  SurfaceJob job = jobOf(plane, Limits4{0, 400, 0, 300});
  job.step = 20.0;
  const auto filmAt = [&job](double x, double y) {
    return film::Bursts(sprayed(job)).filmAt({x, y, 0.0}, Vec3::UnitZ());
  };
  const double middle = filmAt(200, 160);  // under a pass
  // Of sqrt(1 - u^2) at 0, 1/2 and 1/2, and of the mean of passes half a half width apart.
  const double under = 1.0 + 2.0 * std::sqrt(0.75);
  EXPECT_NEAR(middle / job.film, under / M_PI, 0.01);
  EXPECT_NEAR(filmAt(0, 160) / middle, 0.5, 0.02);
  const double side = (1.0 + std::sqrt(0.75)) / under;
  EXPECT_NEAR(filmAt(200, 0) / middle, side, 0.02);
  EXPECT_NEAR(filmAt(0, 0) / middle, side / 2.0, 0.02);
  job.past = 40.0;
  for (const auto& [x, y] : {std::pair{0.0, 160.0},
                             {400.0, 160.0},
                             {200.0, 0.0},
                             {200.0, 300.0},
                             {0.0, 0.0},
                             {400.0, 300.0}}) {
    EXPECT_NEAR(filmAt(x, y) / middle, 1.0, 0.03) << x << ' ' << y;
  }
}

/// 16 lines 20 apart from edge to edge, one more on each side; each 40 longer at both ends.
TEST(Past, LinesAreLongerAndOneMoreLiesBesideThem) {
  SurfaceJob job = jobOf(plane, Limits4{0, 400, 0, 300});
  job.step = 20.0;
  job.past = 40.0;
  const Sprayed s = sprayed(job);
  EXPECT_EQ(s.lines, 18U);
  EXPECT_NEAR(s.chosen.lengths.painted, 18 * 480.0, 1e-6);
  EXPECT_DOUBLE_EQ(s.area, 400.0 * 300.0);
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const Stroke& stroke : s.strokes) {
    low = std::min(low, stroke.from.y());
    high = std::max(high, stroke.from.y());
  }
  EXPECT_NEAR(low, -20.0, 1e-9);
  EXPECT_NEAR(high, 320.0, 1e-9);
}

/// Straight on from the edge of a half cylinder: down from where the surface is upright.
TEST(Past, LinesGoOnStraight) {
  SurfaceJob job = jobOf(cylinder, Limits4{0, 180, 0, 400});
  job.gun.standOff = 50.0;
  job.past = 30.0;
  job.chord = 0.01;
  const Sprayed s = sprayed(job);
  const Vec3 first = s.strokes.front().from;
  EXPECT_NEAR(std::abs(std::abs(first.x()) + std::abs(first.z()) - 230.0), 0.0, 1e-5);
  EXPECT_NEAR(std::min(std::abs(first.x()), std::abs(first.z())), 30.0, 1e-5);
  EXPECT_NEAR((s.strokes.front().normalFrom - s.strokes.front().normalTo).norm(), 0.0, 1e-12);
}

TEST(Past, NothingGoesOnWhereASurfaceHasNoEdge) {
  for (const auto way : {SurfaceJob::Way::alongU, SurfaceJob::Way::alongV}) {
    SurfaceJob ball = jobOf(sphere);
    ball.lines = way;
    ball.past = 40.0;
    EXPECT_EQ(beyond(sprayed(ball), [](const Vec3& p) { return p.norm() < 300.0 + 1e-6; }), 0U);
    SurfaceJob ring = jobOf(torus);
    ring.lines = way;
    ring.past = 40.0;
    EXPECT_EQ(beyond(sprayed(ring),
                     [](const Vec3& p) {
                       const double tube = std::hypot(std::hypot(p.x(), p.y()) - 500.0, p.z());
                       return tube < 150.0 + 1e-6;
                     }),
              0U);
  }
  // Sections through the seam of a torus, and radial ones that end at their axis on a sphere.
  SurfaceJob ring = jobOf(torus);
  ring.lines = SurfaceJob::Parallel{Vec3::UnitY()};
  const double without = sprayed(ring).chosen.lengths.painted;
  ring.past = 30.0;
  EXPECT_NEAR(sprayed(ring).chosen.lengths.painted, without, 1e-6 * without);
}

/// Planes of LIMITS: lines go on along the surface to planes that lie farther out.
TEST(Past, LinesGoBeyondThePlanesOfLimits) {
  SurfaceJob job = jobOf(cylinder, Limits4{0, 360, 0, 400});
  const HalfSpace upper = {Vec3::UnitZ(), 100.0};
  job.patch = *patchOf(cylinder, {Limits4{0, 360, 0, 400}, {upper}}, 1.0);
  job.lines = SurfaceJob::Way::alongU;
  job.past = 25.0;
  job.ends = {{Vec3::UnitZ(), 75.0}};
  job.widePatch = *patchOf(cylinder, {Limits4{0, 360, 0, 400}, job.ends}, 1.0);
  const Sprayed s = sprayed(job);
  EXPECT_NEAR(s.strokes.front().from.z(), 75.0, 1e-6);
  EXPECT_NEAR(std::hypot(s.strokes.front().from.x(), s.strokes.front().from.z()), 200.0, 1e-6);
  // The arc over z = 100 is a third of the turn.
  EXPECT_NEAR(s.area, 2.0 / 3.0 * M_PI * 200.0 * 400.0, 0.01 * s.area);
}

TEST(Walls, AreMetThroughNotTouched) {
  geometry::TriangleMesh square;
  square.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Walls walls(square);
  EXPECT_DOUBLE_EQ(walls.between({3, 4, 5}, {3, 4, -7}).value(), 5.0);
  EXPECT_DOUBLE_EQ(walls.between({0, 5, -3}, {8, 5, 3}).value(), 5.0);  // half of (8, 0, 6)
  EXPECT_FALSE(walls.between({3, 4, 5}, {3, 4, 0}));                    // ends on it
  EXPECT_FALSE(walls.between({3, 4, 0}, {9, 4, 0}));                    // lies in it
  EXPECT_FALSE(walls.between({30, 4, 5}, {30, 4, -7}));
}

/// Inside a box of 400, of which planes keep the middles of two walls: a stand-off of 450 is beyond
/// the other wall; 150 is not. Without the planes the gun comes into the corners. Outside there is
/// no wall.
TEST(Walls, InsideOfABox) {
  SurfaceJob job;
  job.gun.footprint = {40.0, 40.0};
  job.gun.speed = 500.0;
  job.film = 0.05;
  job.lines = SurfaceJob::Parallel{Vec3(0.0, 1.0, 0.3).normalized()};
  const std::vector<HalfSpace> middle = {{Vec3::UnitY(), 100.0},
                                         {-Vec3::UnitY(), -300.0},
                                         {Vec3::UnitZ(), 100.0},
                                         {-Vec3::UnitZ(), -300.0}};
  for (const auto& [inside, planes, standOff, code] : {std::tuple{true, true, 450.0, "E0349"},
                                                       {true, true, 150.0, ""},
                                                       {true, false, 150.0, "E0329"},
                                                       {false, false, 450.0, ""}}) {
    job.wholeMesh = std::make_shared<const MeshSurface>(box(400.0), inside);
    job.mesh =
        planes ? std::make_shared<const MeshSurface>(job.wholeMesh->cutBy(middle)) : job.wholeMesh;
    job.gun.standOff = standOff;
    const Result<Sprayed> result = spraySurface(job);
    EXPECT_EQ(result ? "" : std::string(result.failure().row->code), code) << standOff;
    job.checkRadius = false;
    EXPECT_TRUE(spraySurface(job).ok());
    job.checkRadius = true;
  }
}

/// A floor and a wall that leans away from it by 50 degrees: lines end where they meet, and go on
/// where the floor is open.
TEST(Walls, StopLinesThatWouldGoOn) {
  SurfaceJob job;
  job.gun.footprint = {40.0, 40.0};
  job.gun.standOff = 100.0;
  job.gun.speed = 500.0;
  job.film = 0.05;
  job.past = 30.0;
  job.lines = SurfaceJob::Parallel{Vec3::UnitY()};
  const double x = 400.0 + 300.0 * std::cos(50.0 * M_PI / 180.0);
  const double z = 300.0 * std::sin(50.0 * M_PI / 180.0);
  geometry::TriangleMesh m;
  m.vertices = {{0, 0, 0}, {400, 0, 0}, {x, 0, z}, {0, 400, 0}, {400, 400, 0}, {x, 400, z}};
  m.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  job.mesh = std::make_shared<const MeshSurface>(m, false);
  const Sprayed s = sprayed(job);
  EXPECT_GT(beyond(s, [](const Vec3& p) { return p.x() > -29.0; }), 0U);
  EXPECT_EQ(beyond(s, [](const Vec3& p) { return p.z() > -1e-6; }), 0U);
  EXPECT_EQ(beyond(s, [](const Vec3& p) { return p.z() > 1e-6 || p.x() < 400.0 + 1e-6; }), 0U);
}

/// The first and the last section of a sphere are rings at no edge.
TEST(Past, SectionsOfAClosedBodyHaveNoSides) {
  SurfaceJob job = jobOf(sphere);
  job.lines = SurfaceJob::Parallel{Vec3(0.1, 0.2, 1.0).normalized()};
  job.step = 10.0;
  job.past = 40.0;
  EXPECT_EQ(beyond(sprayed(job), [](const Vec3& p) { return p.norm() < 300.0 + 1e-6; }), 0U);
}

TEST(Walls, AWayThroughACornerGoesThroughTheWork) {
  // Through the edges of a cube's triangles, and through its corners.
  const Walls walls(box(100.0));
  for (const Vec3& from : {Vec3(50.0, 50.0, 200.0), Vec3(25.0, 75.0, 200.0), Vec3(0.0, 0.0, 200.0),
                           Vec3(100.0, 30.0, 200.0)}) {
    EXPECT_TRUE(walls.between(from, Vec3(from.x(), from.y(), 50.0))) << from.transpose();
  }
  const Vec3 out = Vec3(-1.0, -1.0, -1.0);
  EXPECT_TRUE(walls.between(200.0 * Vec3::Ones(), out * 50.0));
}

}  // namespace
}  // namespace arelem::spray
