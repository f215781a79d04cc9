#include "runtime/geometry/kinds/mesh.h"

#include <random>

#include <gtest/gtest.h>

// The signed distance of a mesh against solids whose distance is known.
namespace arelem::surface {
namespace {

/// The box of the given half sizes about the origin, two triangles a side, normals outwards.
Mesh box(const Vec3& half) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? half.x() : -half.x(),
                               (i & 2) != 0 ? half.y() : -half.y(),
                               (i & 4) != 0 ? half.z() : -half.z());
  }
  using Quad = std::array<std::uint32_t, 4>;
  for (const Quad& q : {Quad{0, 2, 3, 1}, Quad{4, 5, 7, 6}, Quad{0, 1, 5, 4}, Quad{2, 6, 7, 3},
                        Quad{0, 4, 6, 2}, Quad{1, 3, 7, 5}}) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return Mesh(std::make_shared<MeshShape>(std::move(mesh)));
}

double distanceToBox(const Vec3& half, const Vec3& p) {
  const Vec3 q = p.cwiseAbs() - half;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

TEST(MeshSurface, DistanceOfABoxInsideOutsideAndAtItsEdges) {
  const Vec3 half(3, 2, 1);
  const Mesh mesh = box(half);
  std::mt19937_64 engine(11);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  Mesh::Hint followed;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(place(engine), place(engine), place(engine));
    Mesh::Hint fresh;
    const Foot foot = mesh.foot(p, fresh);
    EXPECT_NEAR(foot.distance, distanceToBox(half, p), 1e-12) << p.transpose();
    // A search that starts at the last foot finds the same distance.
    EXPECT_DOUBLE_EQ(mesh.foot(p, followed).distance, foot.distance) << p.transpose();
    EXPECT_NEAR(foot.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(distanceToBox(half, p - foot.distance * foot.normal), 0.0, 1e-11);
  }
}

TEST(MeshSurface, PlacesOnTheMeshHaveTheNormalAroundThem) {
  const Mesh mesh = box({1, 1, 1});
  Mesh::Hint hint;
  EXPECT_NEAR((mesh.foot({0.3, 0.2, 1}, hint).normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((mesh.foot({1, 0.2, 1}, hint).normal - Vec3(1, 0, 1).normalized()).norm(), 0.0,
              1e-12);
  EXPECT_NEAR((mesh.foot({1, 1, 1}, hint).normal - Vec3(1, 1, 1).normalized()).norm(), 0.0, 1e-12);
}

TEST(MeshSurface, BendIsThatOfTheDistance) {
  // The second derivative along a direction, by differences, where the foot keeps its feature.
  const Mesh mesh = box({1, 1, 1});
  const std::vector<std::pair<Vec3, Vec3>> cases = {
      {{0.2, 0.1, 2.5}, {1, 2, 0.5}},  // face
      {{2.0, 0.1, 3.0}, {1, 2, 0.5}},  // edge
      {{2.0, 1.7, 3.0}, {1, 2, 0.5}},  // corner
  };
  for (const auto& [p, along] : cases) {
    const Vec3 t = along.normalized();
    constexpr double h = 1e-3;
    Mesh::Hint hint;
    const auto at = [&](double s) { return mesh.foot(p + s * t, hint).distance; };
    const double differences = (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h);
    const Foot foot = mesh.foot(p, hint);
    EXPECT_NEAR(mesh.bend(p, foot, t, hint), differences, 1e-5) << p.transpose();
  }
}

}  // namespace
}  // namespace arelem::surface
