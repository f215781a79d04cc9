#include "runtime/tool/near_triangles.h"

#include <random>

#include <gtest/gtest.h>

#include "runtime/tool/mesh_contact.h"

// The least gap to a mesh, found with what is remembered of earlier positions, against all
// triangles one by one.
namespace arelem::tool {
namespace {

const std::vector<std::vector<double>> cutters = {{0.75},
                                                  {0.75, 0.375},
                                                  {1.0, 0.1875},
                                                  {0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                                  {1.0, 0, 0.5, 0, 0, 0, 2}};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  Vec3 vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }

 private:
  std::mt19937_64 engine_;
};

/// A rough square from -2 to 2 under z = 0.
surface::MeshShape rough(Random& random, int side, double roughness) {
  geometry::TriangleMesh mesh;
  for (int i = 0; i <= side; ++i) {
    for (int k = 0; k <= side; ++k) {
      const double x = 4.0 * i / side - 2.0;
      const double y = 4.0 * k / side - 2.0;
      mesh.vertices.emplace_back(x, y,
                                 0.3 * std::sin(2 * x) * std::cos(y) - random.in(0, roughness));
    }
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (side + 1) + k); };
  for (int i = 0; i < side; ++i) {
    for (int k = 0; k < side; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  return surface::MeshShape(std::move(mesh));
}

double leastOfAll(const surface::MeshShape& shape,
                  const Profile& cutter,
                  const Vec3& te,
                  const Vec3& axis) {
  const TriangleCutter body(Body(cutter), te, axis);
  double least = 1e9;
  for (std::size_t i = 0; i < shape.mesh.triangles.size(); ++i) {
    least = std::min(least, body.gapTo(shape.mesh, i).gap);
  }
  return least;
}

TEST(NearTriangles, TheLeastGapIsThatOfAllTriangles) {
  Random random(21);
  for (const double roughness : {0.0, 0.02, 0.3}) {
    const surface::MeshShape shape = rough(random, 16, roughness);
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      NearTriangles near;
      std::size_t triangle = 0;
      Vec3 te(-1, -0.5, 0.4);
      Vec3 axis = Vec3::UnitZ();
      Vec3 way = random.vector(0.05);
      for (int i = 0; i < 150; ++i) {
        // On and on, aside a little, and now and then somewhere else or with another axis.
        way = i % 20 == 0 ? random.vector(0.05) : way;
        te += way + random.vector(0.004);
        te = i % 50 == 49 ? random.vector(1.5) : te;
        te.z() = std::clamp(te.z(), -0.4, 0.8);
        axis = i % 40 == 39 ? Vec3(Vec3::UnitZ() + random.vector(0.3)).normalized() : axis;
        const TriangleGap found = near.least(shape, cutter, te, axis, triangle);
        EXPECT_NEAR(found.gap, leastOfAll(shape, cutter, te, axis), 1e-11) << i;
        const TriangleCutter there(Body(cutter), te, axis);
        EXPECT_EQ(there.gapTo(shape.mesh, triangle).gap, found.gap) << i;
      }
    }
  }
}

TEST(NearTriangles, NoPlaceOfAWayIsNearerThanItsLowest) {
  Random random(8);
  const surface::MeshShape shape = rough(random, 16, 0.05);
  int close = 0;
  for (const auto& values : cutters) {
    const Profile cutter = *makeProfile(values);
    NearTriangles near;
    for (int i = 0; i < 40; ++i) {
      const Vec3 from = Vec3(random.in(-1.5, 1.5), random.in(-1.5, 1.5), random.in(-0.2, 0.4));
      const Vec3 to = from + random.vector(i % 2 == 0 ? 0.02 : 0.3);
      double least = 1e9;
      for (int k = 0; k <= 40; ++k) {
        const Vec3 te = from + k / 40.0 * (to - from);
        least = std::min(least, leastOfAll(shape, cutter, te, Vec3::UnitZ()));
      }
      EXPECT_LE(near.lowest(shape, cutter, {from, to}, 10.0), least + 1e-11) << i;
      const double aim = least - 0.25 * (to - from).norm();
      const double low = near.lowest(shape, cutter, {from, to}, aim);
      EXPECT_LE(low, aim) << i;
      close += low == aim ? 1 : 0;
    }
  }
  EXPECT_GT(close, 150);  // of 200: the bounds are near enough to be of use
}

TEST(NearTriangles, NoPlaceOfATurningWayIsNearerThanItsLowest) {
  Random random(9);
  const surface::MeshShape shape = rough(random, 16, 0.05);
  int close = 0;
  for (const auto& values : cutters) {
    const Profile cutter = *makeProfile(values);
    NearTriangles near;
    for (int i = 0; i < 40; ++i) {
      Passage way;
      way.from = Vec3(random.in(-1.5, 1.5), random.in(-1.5, 1.5), random.in(-0.2, 0.4));
      way.to = way.from + random.vector(i % 2 == 0 ? 0.02 : 0.3);
      way.axisFrom = (Vec3::UnitZ() + random.vector(0.3)).normalized();
      way.axisTo = (way.axisFrom + random.vector(i % 2 == 0 ? 0.01 : 0.2)).normalized();
      way.turn = std::acos(std::min(1.0, way.axisFrom.dot(way.axisTo)));
      const Vec3 aside = (way.axisTo - std::cos(way.turn) * way.axisFrom) / std::sin(way.turn);
      double least = 1e9;
      for (int k = 0; k <= 40; ++k) {
        const double s = k / 40.0;
        const Vec3 axis = std::cos(s * way.turn) * way.axisFrom + std::sin(s * way.turn) * aside;
        least =
            std::min(least, leastOfAll(shape, cutter, way.from + s * (way.to - way.from), axis));
      }
      EXPECT_LE(near.lowest(shape, cutter, way, 10.0), least + 1e-11) << i;
      const double aim = least - 0.25 * ((way.to - way.from).norm() + way.turn);
      const double low = near.lowest(shape, cutter, way, aim);
      EXPECT_LE(low, aim) << i;
      close += low == aim ? 1 : 0;
    }
  }
  EXPECT_GT(close, 150);  // of 200
}

TEST(NearTriangles, TheGapLiesAboveItsTangent) {
  Random random(4);
  for (int i = 0; i < 400; ++i) {
    const Vec3 center = Vec3(random.in(-1, 1), random.in(-1, 1), random.in(-0.6, 0.6));
    const Vec3 a = center + random.vector(0.5);
    const Vec3 b = center + random.vector(0.5);
    const Vec3 c = center + random.vector(0.5);
    const Facet facet = Facet::of(a, b, c);
    for (const auto& values : cutters) {
      const Profile cutter = *makeProfile(values);
      const Body body(cutter);
      const TriangleGap here = gapOf(PlacedBody(body, Vec3::Zero(), Vec3::UnitZ()), facet);
      EXPECT_LE(here.low, here.gap + 1e-12) << i;
      if (here.gap > -0.1) {  // deeper ones may be on the axis, where the tangent is any
        EXPECT_GE(here.low, here.gap - 1e-6) << i;
      }
      const GapTangent rough = tangentBelow(PlacedBody(body, Vec3::Zero(), Vec3::UnitZ()), facet);
      for (int k = 0; k < 10; ++k) {
        const Vec3 step = random.vector(k % 2 == 0 ? 0.3 : 0.01);
        const double gap = gapOf(PlacedBody(body, step, Vec3::UnitZ()), facet).gap;
        EXPECT_GE(gap, here.low + here.slope.dot(step) - 1e-11) << i;
        EXPECT_GE(gap, rough.low + rough.slope.dot(step) - 1e-11) << i;
      }
    }
  }
}

/// A triangle of a plane through `place`, so large that no border of it is near.
std::array<Vec3, 3> around(const Vec3& place, const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  return {place + 90.0 * u, place - 50.0 * u + 80.0 * v, place - 50.0 * u - 80.0 * v};
}

TEST(NearTriangles, TheTangentTouchesTheGapInsideACutterToo) {
  // Walls that lean over the cutter are deepest at its top, planes below a drill on its axis.
  Random random(6);
  const double lean = std::atan(1.0) / 5.625;  // 8 degrees
  const double center = 0.4 - 0.1 * (1.0 - std::sin(lean)) / std::cos(lean);
  const std::vector<std::vector<double>> all = {{0.75},
                                                {0.75, 0.375},
                                                {1.0, 0.1875},
                                                {0.8, 0.1, center, 0.1, 0, 8, 4},
                                                {0.75, 0, 0.375, 0.2253227321353351, 31, 0, 4}};
  for (int i = 0; i < 300; ++i) {
    const Vec3 normal = random.vector(1.0).normalized();
    for (const auto& values : all) {
      const Profile cutter = *makeProfile(values);
      const Body body(cutter);
      const PlacedBody placed(body, Vec3::Zero(), Vec3::UnitZ());
      const double deep = random.in(0.0, 0.02);
      const auto corners = around((deep - reach(cutter, normal.z())) * normal, normal);
      const Facet plane = Facet::of(corners[0], corners[1], corners[2]);
      const TriangleGap gap = gapOf(placed, plane);
      EXPECT_LE(gap.gap, 0.0) << i;
      EXPECT_NEAR(gap.low, gap.gap, 1e-9) << i << " " << normal.z();
      for (int k = 0; k < 4; ++k) {
        const Vec3 step = random.vector(0.01);
        const double there = gapOf(PlacedBody(body, step, Vec3::UnitZ()), plane).gap;
        EXPECT_GE(there, gap.low + gap.slope.dot(step) - 1e-9) << i << " " << normal.z();
      }
    }
  }
}

TEST(NearTriangles, DepthIsThatOfTheLargestBallInTheCutter) {
  // By hand. A level plane 0.01 above the tip of a drill of 31 degrees: a ball about its place on
  // the axis touches the cone at 0.01 cos 31. A wall that leans over a flat cutter by 30 degrees,
  // 0.01 behind the rim of its top: r (sin 30 + cos 30) = 0.01.
  const Profile drill =
      *makeProfile(std::vector<double>{0.75, 0, 0.375, 0.2253227321353351, 31, 0, 4});
  const auto level = around({0, 0, 0.01}, Vec3::UnitZ());
  const PlacedBody tip(Body(drill), Vec3::Zero(), Vec3::UnitZ());
  EXPECT_NEAR(gapOf(tip, Facet::of(level[0], level[1], level[2])).gap, -0.01 * drill.cosAlpha,
              1e-9);
  const Profile flat = *makeProfile(std::vector<double>{1.0, 0, 0.5, 0, 0, 0, 2});
  const Vec3 over(-std::sqrt(0.75), 0, -0.5);  // from the wall to the cutter
  const auto wall = around(Vec3(0.5, 0, 2) + 0.01 * over, over);
  const PlacedBody end(Body(flat), Vec3::Zero(), Vec3::UnitZ());
  EXPECT_NEAR(gapOf(end, Facet::of(wall[0], wall[1], wall[2])).gap, -0.01 / (0.5 + std::sqrt(0.75)),
              1e-9);
}

TEST(NearTriangles, ASideThatWidensIsDeepestInAWallRightBelowItsTop) {
  // By hand: there the wall is as far inside, x, as the radius exceeds its distance from the axis;
  // the side leans by 8 degrees. The wall is taller than the cutter. A ball about a place of the
  // wall, r below the top, is x cos 8 - r sin 8 from the side: r (1 + sin 8) = x cos 8.
  const double lean = std::atan(1.0) / 5.625;  // 8 degrees
  const double center = 0.4 - 0.1 * (1.0 - std::sin(lean)) / std::cos(lean);
  const Profile cutter = *makeProfile(std::vector<double>{0.8, 0.1, center, 0.1, 0, 8, 4});
  const Body body(cutter);
  const std::array<Vec3, 3> corners = {Vec3(1, -50, -20), Vec3(1, 50, -20), Vec3(1, 0, 60)};
  const Facet wall = Facet::of(corners[0], corners[1], corners[2]);
  for (const double away : {0.7, 0.5, -0.5, -0.7}) {
    const double inside = cutter.sideEnd.rho - std::abs(away);
    const TriangleGap gap = gapOf(PlacedBody(body, {1 - away, 0, 0}, Vec3::UnitZ()), wall);
    EXPECT_NEAR(gap.gap, -inside * cutter.cosBeta / (1.0 + cutter.sinBeta), 1e-9) << away;
  }
}

}  // namespace
}  // namespace arelem::tool
