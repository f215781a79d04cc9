#include <random>

#include <gtest/gtest.h>

#include "runtime/certify/prove.h"

// A tool end on a mesh: bounds of its distance along straight ways.
namespace arelem::certify {
namespace {

using State = Verdict::State;

/// A roof along y, its ridge at z = 0 and its sides falling by `slope`.
surface::Mesh roof(double slope) {
  geometry::TriangleMesh mesh;
  const double z = -9.0 * slope;
  mesh.vertices = {{-9, -9, z}, {0, -9, 0}, {0, 9, 0}, {-9, 9, z}, {9, -9, z}, {9, 9, z}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  return surface::Mesh(std::make_shared<const surface::MeshShape>(std::move(mesh)));
}

Verdict along(const surface::AnySurface& mesh,
              const Vec3& from,
              const Vec3& to,
              double inner,
              double outer,
              double side = 1.0) {
  const auto probe = makeProbe(mesh, {nullptr, side, 0.0});
  probe->take(Chord(from, to, Vec3::UnitZ(), Vec3::UnitZ()));
  Node first = probe->at(0.0);
  return prove(*probe, {inner, outer, 1e-9, true}, first);
}

TEST(MeshPoint, AWayThatNearlyReachesTheLimitIsDecidedAtOnce) {
  // The way runs level above the ridge of a roof of slope 3 in 4, whose sides are 0.8 of the
  // vertical away.
  const surface::AnySurface mesh = roof(0.75);
  constexpr double limit = 0.0005;
  for (const double off : {0.0, 1e-8, 1e-5}) {
    const double height = (limit - off) / 0.8;
    const Vec3 from(-4, -8, -3.0 + height);
    const Vec3 to(-4, 8, -3.0 + height);
    for (const double inner : {0.0, limit}) {
      const Verdict v = along(mesh, from, to, inner, limit);
      EXPECT_TRUE(v.good()) << off;
      EXPECT_NEAR(v.greatest.measured, limit - off, 1e-12);
      EXPECT_NEAR(v.greatest.proven, limit - off, 0.01 * (inner + limit));
      EXPECT_LE(v.nodes, 64U);
    }
    EXPECT_EQ(along(mesh, from + Vec3(0, 0, 2.0 * off + 1e-7), to, 0.0, limit).outer,
              State::refuted);
  }
}

TEST(MeshPoint, AChordAcrossTheRidgeIsInsideByItsHeight) {
  // From side to side, 0.001 below the ridge: 0.8 of that from either side.
  const surface::AnySurface mesh = roof(0.75);
  const Vec3 from(-0.001 / 0.75, -1, -0.001);
  const Vec3 to(0.001 / 0.75, 1, -0.001);
  const Verdict v = along(mesh, from, to, 0.00081, 0.0);
  EXPECT_TRUE(v.good());
  EXPECT_NEAR(v.least.measured, -0.0008, 1e-12);
  EXPECT_EQ(along(mesh, from, to, 0.00079, 0.0).inner, State::refuted);
  // The other side counts the other way round.
  EXPECT_TRUE(along(mesh, from, to, 0.0, 0.00081, -1.0).good());
  EXPECT_EQ(along(mesh, from, to, 0.0, 0.00079, -1.0).outer, State::refuted);
}

TEST(MeshPoint, BoundsHoldAlongEveryWay) {
  std::mt19937_64 engine(8);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  for (int i = 0; i < 300; ++i) {
    const surface::Mesh mesh = roof(in(-2, 2));
    const surface::AnySurface any = mesh;
    const auto place = [&] { return Vec3(in(-10, 10), in(-10, 10), in(-4, 4)); };
    const Vec3 from = place();
    const Vec3 to = i % 2 == 0 ? place() : Vec3(from + 0.1 * place());
    const double side = i % 3 == 0 ? -1.0 : 1.0;
    const auto probe = makeProbe(any, {nullptr, side, 0.0});
    probe->take(Chord(from, to, Vec3::UnitZ(), Vec3::UnitZ()));
    const Node a = probe->at(0.0);
    const Node b = probe->at(1.0);
    const Stretch range = probe->over(a, b, -1.0);
    surface::Mesh::Hint hint;
    for (int k = 0; k <= 200; ++k) {
      const double gap = side * mesh.foot(from + k / 200.0 * (to - from), hint).distance;
      EXPECT_GE(gap, range.low - 1e-12) << i;
      EXPECT_LE(gap, range.high + 1e-12) << i;
    }
  }
}

}  // namespace
}  // namespace arelem::certify
