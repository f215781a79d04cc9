#include "runtime/tool/mesh_contact.h"

#include <random>

#include <gtest/gtest.h>

// The gap of cutter and triangle against brute force over many points of the triangle.
namespace arelem::tool {
namespace {

const std::vector<std::vector<double>> cutters = {{0.75},
                                                  {0.75, 0.375},
                                                  {1.0, 0.1875},
                                                  {0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                                  {1.0, 0, 0.5, 0, 0, 0, 2}};

geometry::TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  geometry::TriangleMesh mesh;
  mesh.vertices = {a, b, c};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

/// Signed distance of a place to the body of a cutter that stands at the origin along z.
double toBody(const Profile& cutter, const Vec3& p) {
  ProfilePoint nearest;
  return distanceTo(cutter, {std::hypot(p.x(), p.y()), p.z()}, nearest);
}

TEST(MeshContact, TheGapIsTheLeastOfTheTriangle) {
  std::mt19937_64 engine(5);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  constexpr int steps = 60;
  for (int i = 0; i < 100; ++i) {
    const Vec3 center(in(-1, 1), in(-1, 1), in(-1.5, 1));
    const auto corner = [&] { return Vec3(center + Vec3(in(-1, 1), in(-1, 1), in(-1, 1))); };
    const auto mesh = triangle(corner(), corner(), corner());
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (mesh.corner(0, k) - mesh.corner(0, (k + 1) % 3)).norm());
    }
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Body shape(cutter);
      const TriangleCutter body(shape, Vec3::Zero(), Vec3::UnitZ());
      const double gap = body.gapTo(mesh, 0).gap;
      double least = 1e9;
      for (int u = 0; u <= steps; ++u) {
        for (int v = 0; v + u <= steps; ++v) {
          const Vec3 p = mesh.corner(0, 0) +
                         static_cast<double>(u) / steps * (mesh.corner(0, 1) - mesh.corner(0, 0)) +
                         static_cast<double>(v) / steps * (mesh.corner(0, 2) - mesh.corner(0, 0));
          least = std::min(least, toBody(cutter, p));
        }
      }
      // The distance is 1-Lipschitz: between the places it is lower by no more than half a step.
      EXPECT_LE(gap, least + 1e-8) << i;
      EXPECT_GE(gap, least - longest / steps) << i;
      EXPECT_TRUE(body.mayReach(mesh, 0, gap + 1e-9)) << i;
    }
  }
}

TEST(MeshContact, TheNormalIsTheGradientOfTheGap) {
  std::mt19937_64 engine(9);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const auto corner = [&] { return Vec3(in(-2, 2), in(-2, 2), in(-2, -0.4)); };
    const auto mesh = triangle(corner(), corner(), corner());
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Body shape(cutter);
      constexpr double h = 1e-5;
      const auto gapAt = [&](const Vec3& te) {
        return TriangleCutter(shape, te, Vec3::UnitZ()).gapTo(mesh, 0).gap;
      };
      const TriangleGap c = TriangleCutter(shape, Vec3::Zero(), Vec3::UnitZ()).gapTo(mesh, 0);
      for (int k = 0; k < 3; ++k) {
        const Vec3 step = h * Vec3::Unit(k);
        const double up = (gapAt(step) - c.gap) / h;
        const double down = (c.gap - gapAt(-step)) / h;
        if (std::abs(up - down) < 1e-3) {  // not where the contact jumps
          EXPECT_NEAR(0.5 * (up + down), c.normal[k], 1e-3) << i;
          ++tried;
        }
      }
    }
  }
  EXPECT_GT(tried, 4000);
}

TEST(MeshContact, OnAWayNoNearerPlaceIsMissed) {
  std::mt19937_64 engine(3);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  int excluded = 0;
  for (int i = 0; i < 250; ++i) {
    const Vec3 center(in(-3, 3), in(-3, 3), in(-3, 2));
    const auto corner = [&] {
      return Vec3(center + Vec3(in(-0.5, 0.5), in(-0.5, 0.5), in(-0.5, 0.5)));
    };
    const auto mesh = triangle(corner(), corner(), corner());
    const Vec3 low = mesh.corner(0, 0).cwiseMin(mesh.corner(0, 1)).cwiseMin(mesh.corner(0, 2));
    const Vec3 high = mesh.corner(0, 0).cwiseMax(mesh.corner(0, 1)).cwiseMax(mesh.corner(0, 2));
    const Vec3 sweep(in(-1, 1), in(-1, 1), in(-0.2, 0.2));
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Body shape(cutter);
      double least = 1e9;
      for (int k = -20; k <= 20; ++k) {
        const TriangleCutter there(shape, k / 20.0 * sweep, Vec3::UnitZ());
        least = std::min(least, there.gapTo(mesh, 0).gap);
      }
      const TriangleCutter body(shape, Vec3::Zero(), Vec3::UnitZ(), sweep);
      EXPECT_TRUE(body.mayReach(mesh, 0, least + 1e-9)) << i;
      EXPECT_TRUE(body.mayReach(0.5 * (low + high), 0.5 * (high - low), least + 1e-9)) << i;
      excluded += body.mayReach(mesh, 0, least - 0.3) ? 0 : 1;
    }
  }
  EXPECT_GT(excluded, 900);  // the bounds are near enough to be of use
}

TEST(MeshContact, PencilCases) {
  // A triangle that covers the place below the tool: flat end at height 2, ball of radius 1
  // likewise.
  const auto flat = triangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0});
  const Profile end = *makeProfile(std::vector<double>{2.0});
  const Profile ball = *makeProfile(std::vector<double>{2.0, 1.0});
  EXPECT_NEAR(TriangleCutter(Body(end), {0, 0, 2}, Vec3::UnitZ()).gapTo(flat, 0).gap, 2.0, 1e-14);
  EXPECT_NEAR(TriangleCutter(Body(ball), {0, 0, 2}, Vec3::UnitZ()).gapTo(flat, 0).gap, 2.0, 1e-14);
  // A wall x = 5 beside the shank of radius 1.
  const auto wall = triangle({5, -9, -9}, {5, 9, -9}, {5, 0, 30});
  EXPECT_NEAR(TriangleCutter(Body(end), {0, 0, 0}, Vec3::UnitZ()).gapTo(wall, 0).gap, 4.0, 1e-12);
  // The corner (2, 0, -1) below the edge of the flat end: 1 across and 1 down.
  const auto point = triangle({2, 0, -1}, {9, -3, -9}, {9, 3, -9});
  EXPECT_NEAR(TriangleCutter(Body(end), {0, 0, 0}, Vec3::UnitZ()).gapTo(point, 0).gap, std::sqrt(2.0),
              1e-9);
}

}  // namespace
}  // namespace arelem::tool
