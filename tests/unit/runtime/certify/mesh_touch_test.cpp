#include <gtest/gtest.h>

#include "runtime/certify/guide.h"

// A lower bound is sought only as far as a limit asks for it, and reaches that limit.
namespace arelem::certify {
namespace {

TEST(MeshTouch, ABoundReachesItsLimitWhateverTheThickness) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const surface::Mesh surface(std::make_shared<const surface::MeshShape>(std::move(mesh)));
  const tool::Profile cutter = *tool::makeProfile(std::vector<double>{1.5, 0.25});
  for (const double limit : {0.0005, 0.001, 0.0007, 0.003}) {
    const Allowed allowed{limit, limit, 1e-6};
    for (int k = -60; k <= 60; ++k) {
      const double thick = 0.001 * k;
      // Half the tolerance above the surface and its thickness.
      const Location at{Vec3(0.1, 0.2, thick + 0.5 * limit), Vec3::UnitZ()};
      const Touch t = touch(surface, {&cutter, 1.0, thick}, at, allowed);
      EXPECT_GE(t.low, -limit - allowed.slack) << limit << " " << thick;
      EXPECT_NEAR(t.high, 0.5 * limit, 1e-12);
    }
  }
}

}  // namespace
}  // namespace arelem::certify
