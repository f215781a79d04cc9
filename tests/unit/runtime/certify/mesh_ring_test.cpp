#include <random>

#include <gtest/gtest.h>

#include "runtime/certify/mesh_ring_probe.h"

// A ring on a mesh: bounds of its distance along cut vectors, over edges that stand out and over
// hollow ones.
namespace arelem::certify {
namespace {

/// Eight triangles around the origin. The top may be below the corners beside it: then it is the
/// ground of a hollow.
surface::Mesh diamond(double top) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {{3, 0.2, 0}, {0.1, 3, 0.3},   {-3, 0, -0.2},
                   {0, -3, 0},  {0.2, 0.1, top}, {0, 0, -4}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.triangles.push_back({i, next, 4});
    mesh.triangles.push_back({next, i, 5});
  }
  return surface::Mesh(std::make_shared<const surface::MeshShape>(std::move(mesh)));
}

TEST(MeshRing, BoundsHoldOverEveryEdge) {
  std::mt19937_64 engine(15);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  tool::Profile ring;
  ring.ring = true;
  ring.f = 0.1;
  int proven = 0;
  for (int i = 0; i < 100; ++i) {
    const surface::Mesh mesh = diamond(in(-1.5, 2.5));
    ring.e = in(0.05, 0.6);
    const double side = i % 4 == 0 ? -1.0 : 1.0;
    const Vec3 from(in(-2, 2), in(-2, 2), in(0, 2));
    const Vec3 to = from + in(0.001, 0.3) * Vec3(in(-1, 1), in(-1, 1), in(-0.2, 0.2));
    const Vec3 axis = Vec3(in(-0.5, 0.5), in(-0.5, 0.5), 1.0).normalized();
    const Vec3 other =
        i % 2 == 0 ? axis : (axis + 0.05 * Vec3(in(-1, 1), in(-1, 1), 0)).normalized();
    const auto probe = makeMeshRingProbe(mesh, {&ring, side, 0.0});
    probe->take(Chord(from, to, axis, other));
    const Node a = probe->at(0.0);
    const Node b = probe->at(1.0);
    double least = std::min(a.high, b.high);
    double greatest = std::max(a.high, b.high);
    for (int k = 1; k < 40; ++k) {
      const double gap = probe->at(k / 40.0).high;
      least = std::min(least, gap);
      greatest = std::max(greatest, gap);
    }
    for (const double off : {1e-3, 1e-5, 1e-8}) {
      EXPECT_LT(probe->over(a, b, least + off).low, least + off) << i;
      const Stretch range = probe->over(a, b, least - off);
      EXPECT_LE(range.low, least) << i;
      EXPECT_GE(range.high, greatest - 1e-12) << i;
      proven += range.low >= least - off ? 1 : 0;
    }
  }
  EXPECT_GE(proven, 200);
}

/// Just above a ridge, and as far below it as the limit allows.
TEST(MeshRing, WaysAlongARidgeAreProven) {
  const surface::Mesh mesh = diamond(2.0);
  tool::Profile ring;
  ring.ring = true;
  ring.e = 0.05;
  const Vec3 bottom(3, 0.2, 0);
  const Vec3 top(0.2, 0.1, 2.0);
  const Vec3 along = (top - bottom).normalized();
  const Vec3 across = Vec3::UnitY();
  const Vec3 axis = across.cross(along).z() > 0.0 ? across.cross(along) : along.cross(across);
  const Vec3 onRidge = bottom + 0.3 * (top - bottom);
  for (const double height : {4e-7, -4e-7}) {
    // The ring touches the ridge with its side.
    const Vec3 lean = (axis.normalized() + 0.4 * across).normalized();
    const Vec3 out = (across - across.dot(lean) * lean).normalized();
    Vec3 from = onRidge + ring.e * out;
    const auto probe = makeMeshRingProbe(mesh, {&ring, 1.0, 0.0});
    for (int i = 0; i < 20; ++i) {
      probe->take(Chord(from, from + along, lean, lean));
      from += (height - probe->at(0.0).high) * axis.normalized();
    }
    const Node a = probe->at(0.0);
    const Node b = probe->at(1.0);
    EXPECT_NEAR(a.high, height, 1e-9);
    const double aim = std::min(a.high, b.high) - 1e-7;
    EXPECT_GE(probe->over(a, b, aim).low, aim) << height;
  }
}

}  // namespace
}  // namespace arelem::certify
