#include "runtime/geometry/triangle_tree.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "runtime/geometry/place_order.h"

// The tree of boxes against all triangles one by one.
namespace arelem::geometry {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  Vec3 place(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 engine_;
};

TriangleMesh soup(Random& random, std::size_t count, double size) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 middle = random.place(10.0);
    for (int k = 0; k < 3; ++k) {
      mesh.vertices.push_back(middle + random.place(size));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

double distance(const TriangleMesh& mesh, std::size_t i, const Vec3& p) {
  return (nearestOn(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2), p).point - p).norm();
}

TEST(TriangleTree, TheNearestIsThatOfAll) {
  Random random(1);
  for (const std::size_t count : {1U, 2U, 3U, 50U, 1000U}) {
    const TriangleMesh mesh = soup(random, count, 0.7);
    const TriangleTree tree(mesh);
    for (int i = 0; i < 50; ++i) {
      const Vec3 p = random.place(i % 2 == 0 ? 12.0 : 60.0);
      double least = 1e9;
      for (std::size_t k = 0; k < count; ++k) {
        least = std::min(least, distance(mesh, k, p));
      }
      EXPECT_EQ(distance(mesh, tree.nearest(mesh, p, -1), p), least);
      EXPECT_EQ(distance(mesh, tree.nearest(mesh, p, static_cast<int>(count / 2)), p), least);
    }
  }
}

/// Enters boxes near a place.
struct Near {
  const TriangleMesh& mesh;
  Vec3 place;
  double radius;
  std::multiset<std::size_t> visited;

  [[nodiscard]] bool enters(const Vec3& center, const Vec3& half) const {
    return ((place - center).cwiseAbs() - half).cwiseMax(0.0).norm() <= radius;
  }
  void visit(std::size_t i) { visited.insert(i); }
};

TEST(TriangleTree, ASearchVisitsEveryTriangleOfTheBoxesItEntersOnce) {
  Random random(2);
  const TriangleMesh mesh = soup(random, 700, 0.5);
  const TriangleTree tree(mesh);
  for (const double radius : {0.0, 2.0, 100.0}) {
    Near search{mesh, random.place(8.0), radius, {}};
    tree.search(search);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      EXPECT_LE(search.visited.count(i), 1U);
      if (distance(mesh, i, search.place) <= radius) {
        EXPECT_EQ(search.visited.count(i), 1U);
      }
    }
  }
}

TEST(TriangleTree, TrianglesAtOnePlaceHaveATreeToo) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(300, {0, 1, 2});
  const TriangleTree tree(mesh);
  EXPECT_EQ(tree.nearest(mesh, {2, 2, 2}, -1), 0U);
  Near search{mesh, Vec3::Zero(), 1.0, {}};
  tree.search(search);
  EXPECT_EQ(search.visited.size(), 300U);
}

TEST(PlaceOrder, KeysAscendAndEveryTriangleIsThere) {
  Random random(3);
  const PlaceOrder order = PlaceOrder::of(soup(random, 5000, 0.1));
  EXPECT_TRUE(std::is_sorted(order.keys.begin(), order.keys.end()));
  const std::set<std::uint32_t> all(order.triangles.begin(), order.triangles.end());
  EXPECT_EQ(all.size(), 5000U);
  EXPECT_EQ(*all.rbegin(), 4999U);
}

}  // namespace
}  // namespace arelem::geometry
