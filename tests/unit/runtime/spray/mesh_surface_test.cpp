// Sections of meshes against what they are meshes of.
#include <cmath>

#include <gtest/gtest.h>

#include "runtime/film/map.h"
#include "runtime/spray/surface/gap.h"
#include "runtime/spray/surface/surface_job.h"
#include "tests/unit/runtime/spray/box_mesh.h"

namespace arelem::spray {
namespace {

/// Half a cylinder about the y axis, radius 100, length 400, its normals outside.
geometry::TriangleMesh halfCylinder(int round, int along) {
  geometry::TriangleMesh m;
  for (int i = 0; i <= round; ++i) {
    for (int k = 0; k <= along; ++k) {
      const double t = M_PI * i / round;
      m.vertices.emplace_back(100.0 * std::cos(t), 400.0 * k / along, 100.0 * std::sin(t));
    }
  }
  const auto corner = [&](int i, int k) { return static_cast<std::uint32_t>(i * (along + 1) + k); };
  for (int i = 0; i < round; ++i) {
    for (int k = 0; k < along; ++k) {
      m.triangles.push_back({corner(i, k), corner(i, k + 1), corner(i + 1, k + 1)});
      m.triangles.push_back({corner(i, k), corner(i + 1, k + 1), corner(i + 1, k)});
    }
  }
  return m;
}

TEST(MeshSurfaces, ACylinderHasItsNormalsRadiusAndArea) {
  const MeshSurface surface(halfCylinder(180, 20), false);
  EXPECT_NEAR(surface.area(), M_PI * 100.0 * 400.0, 10.0);
  const std::vector<CuttingPlane> planes = {{Vec3::UnitY(), 130.0, std::nullopt, {}}};
  const std::vector<SurfaceLine> lines = surface.sections(planes, 0.5);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT(lines[0].size(), 40U);
  for (const LinePoint& p : lines[0]) {
    const Vec3 out = Vec3(p.place.x(), 0.0, p.place.z()).normalized();
    EXPECT_GT(p.normal.dot(out), std::cos(0.01));
    EXPECT_NEAR(p.place.y(), 130.0, 1e-9);
    EXPECT_NEAR(std::hypot(p.place.x(), p.place.z()), 100.0, 0.02);
  }
  EXPECT_NEAR(*surface.smallestRadius(planes, 10.0), 100.0, 2.0);
  EXPECT_FALSE(surface.smallestRadius({{Vec3::UnitZ(), 50.0, std::nullopt, {}}}, 10.0).has_value());
  EXPECT_FALSE(surface.smallestHollow(planes, 10.0).has_value());
  EXPECT_NEAR(*MeshSurface(halfCylinder(180, 20), true).smallestHollow(planes, 10.0), 100.0, 2.0);
  const MeshSurface inside(halfCylinder(18, 2), true);
  EXPECT_LT(inside.sections(planes, 0.5)[0][3].normal.z(), 0.0);
}

TEST(MeshSurfaces, LinesEndAtCreases) {
  const MeshSurface surface(box(100.0), false);
  const auto lines = surface.sections({{Vec3::UnitZ(), 30.0, std::nullopt, {}}}, 0.5);
  ASSERT_EQ(lines.size(), 4U);
  for (const SurfaceLine& line : lines) {
    EXPECT_NEAR((line.back().place - line.front().place).norm(), 100.0, 1e-9);
    for (const LinePoint& p : line) {
      EXPECT_NEAR(p.normal.cwiseAbs().maxCoeff(), 1.0, 1e-9);
      EXPECT_GT(p.normal.dot(p.place - Vec3(50, 50, 50)), 0.0);
    }
  }
  EXPECT_EQ(surface.meanNormal(), Vec3::Zero());
}

TEST(MeshSurfaces, RadialSectionsStayOnTheirSide) {
  const MeshSurface surface(box(100.0), false);
  CuttingPlane plane;
  plane.place = Vec3(50, 50, 0);
  plane.half = Vec3::UnitX();
  plane.normal = Vec3::UnitZ().cross(*plane.half);
  plane.level = plane.normal.dot(plane.place);
  const auto lines = surface.sections({plane}, 0.5);
  ASSERT_EQ(lines.size(), 3U);  // bottom, side, top
  for (const SurfaceLine& line : lines) {
    for (const LinePoint& p : line) {
      EXPECT_GE(p.place.x(), 50.0 - 1e-9);
    }
  }
}

TEST(MeshSurfaces, RadialSectionsBeginBehindTheEmptySide) {
  EXPECT_FALSE(middleOfGap({{0, 120}, {120, 240}, {240, 0}}).has_value());
  EXPECT_NEAR(*middleOfGap({{0, 90}, {90, 180}}), 270.0, 0.3);
  EXPECT_NEAR(*middleOfGap({{100, 10}, {100, 270}}), 320.0, 0.3);
  EXPECT_NEAR(*middleOfGap({{-170, 20}, {20, -170}}), 285.0, 0.3);  // both the short way
}

TEST(MeshSurfaces, SprayedAsTheCylinderThatTheyAre) {
  SurfaceJob job;
  job.mesh = std::make_shared<const MeshSurface>(halfCylinder(180, 20), false);
  job.gun.kind = Gun::Kind::cone;
  job.gun.footprint = {20.0, 20.0};
  job.gun.standOff = 150.0;
  job.gun.flow = 300.0;
  job.film = 0.05;
  job.lines = SurfaceJob::Parallel{Vec3::UnitY()};
  const Result<Sprayed> sprayed = spraySurface(job);
  ASSERT_TRUE(sprayed.ok()) << sprayed.failure().message;
  EXPECT_EQ(sprayed->lines, 21U);  // 400 / 20
  EXPECT_NEAR(sprayed->chosen.lengths.painted, 21 * M_PI * 100.0, 30.0);
  EXPECT_NEAR(*sprayed->radiusAlong, 100.0, 2.0);
  EXPECT_FALSE(sprayed->radiusAcross.has_value());
  // Seen from the side of its normals, the film is near the wanted one (the nozzle's way is
  // longer).
  const film::Map map = film::mapOf(*sprayed, 10.0);
  EXPECT_NEAR(map.statistics.area, M_PI * 100.0 * 400.0, 100.0);
  EXPECT_NEAR(map.statistics.mean, 0.05, 0.008);
  job.gun.footprint = {120.0, 120.0};
  EXPECT_EQ(spraySurface(job).failure().row->code, std::string("E0379"));
}

}  // namespace
}  // namespace arelem::spray
