// Radii of curvature along the lines and across, by Euler's theorem.
#include "runtime/spray/surface/radii.h"

#include <cmath>

#include <gtest/gtest.h>

#include "runtime/spray/surface/surface_job.h"

namespace arelem::spray {
namespace {

Patch patch(EntityType type, std::vector<double> canon, std::optional<Limits4> limits) {
  Entity e;
  e.type = type;
  e.canon = std::move(canon);
  Result<Patch> made = patchOf(e, {limits, {}}, 1.0);
  if (!made) {
    ADD_FAILURE() << made.failure().message;
    return {};
  }
  return *made;
}
Patch tube(double from, double to) {
  return patch(EntityType::cylinder, {0, 0, 0, 0, 1, 0, 100}, Limits4{from, to, 0, 300});
}
Patch ring() {
  return patch(EntityType::torus, {0, 0, 0, 0, 0, 1, 200, 50}, std::nullopt);
}
SurfaceJob job(Patch p) {
  SurfaceJob j;
  j.patch = std::move(p);
  j.gun.kind = Gun::Kind::cone;
  j.gun.footprint = {20.0, 20.0};
  j.gun.standOff = 30.0;
  j.gun.speed = 500.0;
  j.film = 0.05;
  return j;
}

/// Sections run as their planes do, not as u and v.
TEST(SurfaceRadii, OfSectionsAreAlongThem) {
  const Patch wall = tube(0, 80);  // its axis is y
  const auto square = [](const Vec3& normal) { return [normal](const Vec3&) { return normal; }; };
  Radii radii = smallestRadii(wall, square(Vec3::UnitX()));
  EXPECT_FALSE(radii.along.has_value());  // lines along the axis
  EXPECT_NEAR(*radii.across, 100.0, 1e-3);
  radii = smallestRadii(wall, square(Vec3::UnitY()));
  EXPECT_NEAR(*radii.along, 100.0, 1e-3);
  EXPECT_FALSE(radii.across.has_value());
  // At the middle of a narrow piece, where the tube's normal is x, a section at 30 degrees to the
  // circles has cos^2 of their bend (Euler): 100 / cos^2 30; square to it 100 / sin^2 30.
  const Patch strip = tube(-1, 1);
  const double h = std::sqrt(0.75);
  const Vec3 normal = strip.normal(0.0, 100.0);
  const Vec3 plane = h * Vec3::UnitY() + 0.5 * normal.cross(Vec3::UnitY());
  radii = smallestRadii(strip, square(plane));
  EXPECT_NEAR(*radii.along, 100.0 / 0.75, 0.05);
  EXPECT_NEAR(*radii.across, 100.0 / 0.25, 0.05);
  // Through the axis of a torus: the circles of the tube.
  radii = smallestRadii(
      ring(), [](const Vec3& place) -> Vec3 { return Vec3::UnitZ().cross(place).normalized(); });
  EXPECT_NEAR(*radii.along, 50.0, 1e-3);
  EXPECT_NEAR(*radii.across, 150.0, 1e-3);
}

TEST(SurfaceJobs, TheBetterDirectionOfSectionsIsTold) {
  SurfaceJob j = job(tube(0, 80));
  j.lines = SurfaceJob::Parallel{Vec3::UnitY()};  // circles
  EXPECT_EQ(spraySurface(j)->advice,
            "sections square to these would run where the surface bends less");
  j.lines = SurfaceJob::Parallel{Vec3::UnitX()};  // straight
  EXPECT_EQ(spraySurface(j)->advice, "");
  EXPECT_FALSE(spraySurface(j)->radiusAlong.has_value());
  j = job(ring());
  j.lines = SurfaceJob::Radial{Vec3::Zero(), Vec3::UnitZ()};
  EXPECT_EQ(spraySurface(j)->advice,
            "sections square to the axis would run where the surface bends less");
}

}  // namespace
}  // namespace arelem::spray
