#include "runtime/tool/upright_touch.h"

#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "runtime/tool/triangle_gap.h"

// Touches of an upright cutter that comes down, against gaps and against all places of triangles.
namespace arelem::tool {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
/// Ball, flat, bull-nose, tapered with a corner radius, tapered with a sharp corner.
const std::vector<std::vector<double>> cutters = {
    {1.0, 0.5},
    {1.0, 0.0},
    {1.0, 0.25},
    {1.0, 0.125, 0.5 - 0.125 * std::tan(41 * degree), 0.125, 0, 8, 3},
    {1.0, 0.0, 0.5, 0.0, 0, 30, 2}};

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
  Vec3 place(double size, double height) {
    return {in(-size, size), in(-size, size), in(-height, height)};
  }

 private:
  std::mt19937_64 engine_;
};

UprightFacet facetOf(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = (b - a).cross(c - a).normalized();
  return {{a, b, c}, n.z() < 0.0 ? Vec3(-n) : n};
}

UprightTouch touchOf(const Profile& cutter, double gap) {
  return UprightTouch(*UprightProfile::of(cutter, gap));
}

TEST(UprightTouch, BallTouchesFacetEdgeAndCorner) {
  const Profile cutter = *makeProfile(cutters[0]);
  const UprightTouch touch = touchOf(cutter, 0.0);
  // A level facet: from the tool end. Its edge y = 0.3: a circle 0.3 beside the middle, 0.4 high.
  const UprightFacet level = facetOf({-9, 0.3, 1}, {9, 0.3, 1}, {0, 9, 1});
  EXPECT_NEAR(touch.of(level, 0.0)->z, 1.0 - 0.5 + 0.4, 1e-15);
  EXPECT_NEAR(touch.of(facetOf({-9, -9, 1}, {9, -9, 1}, {0, 9, 1}), 0.2)->z, 1.0, 1e-15);
  // A facet that rises by 3 in 4: the ball's middle is 5/4 of its radius above it.
  const auto slanting = touch.of(facetOf({-8, -9, -6}, {8, -9, 6}, {0, 9, 0}), 0.0);
  EXPECT_NEAR(slanting->z, 0.625 - 0.5, 1e-15);
  EXPECT_LT((slanting->normal - Vec3(-0.6, 0.0, 0.8)).norm(), 1e-15);
  // A corner 0.3 ahead.
  const auto corner = touch.of(facetOf({0.3, 0, 2}, {1, 0.1, -9}, {1, -0.1, -9}), 0.0);
  EXPECT_NEAR(corner->z, 2.0 - 0.1, 1e-15);
  EXPECT_LT((corner->normal - Vec3(-0.6, 0.0, 0.8)).norm(), 1e-15);
  EXPECT_FALSE(touch.of(facetOf({0.6, 0, 2}, {1, 0.1, 2}, {1, -0.1, 2}), 0.0));
}

TEST(UprightTouch, FlatTouchesAnEdgeWithItsRim) {
  // An edge 0.3 beside the axis that rises by 1 in 2 meets the rim 0.4 ahead.
  const UprightTouch touch = touchOf(*makeProfile(cutters[1]), 0.0);
  const auto found = touch.of(facetOf({-2, 0.3, -1}, {2, 0.3, 1}, {0, 9, -30}), 0.0);
  EXPECT_NEAR(found->z, 0.2, 1e-15);
}

/// The least gap with the tool end where it touches is the gap that the profile was thickened by.
TEST(UprightTouch, TheGapIsTheThicknessWhereItTouches) {
  Random random(5);
  for (const auto& values : cutters) {
    const Profile cutter = *makeProfile(values);
    const Body body(cutter);
    for (const double gap : {0.0, 0.01, 0.2, -0.002}) {
      const auto profile = UprightProfile::of(cutter, gap);
      ASSERT_TRUE(profile);
      const UprightTouch touch(*profile);
      int found = 0;
      for (int i = 0; i < 2000; ++i) {
        const double size = i % 2 == 0 ? 0.2 : 1.0;
        const Vec3 middle = random.place(0.7, 0.2);
        const UprightFacet facet = facetOf(middle + random.place(size, 0.4 * size),
                                           middle + random.place(size, 0.4 * size),
                                           middle + random.place(size, 0.4 * size));
        const double s = random.in(-0.3, 0.3);
        const auto at = touch.of(facet, s);
        const PlacedBody low(body, {s, 0.0, at ? at->z : -0.3}, Vec3::UnitZ());
        const auto& c = facet.corners;
        const TriangleGap measured = gapOf(low, Facet::of(c[0], c[1], c[2]));
        if (!at) {
          EXPECT_GE(measured.gap, gap - 1e-9);
        } else if (!at->beyond) {
          ++found;
          EXPECT_NEAR(measured.gap, gap, 1e-9) << cutter.r << ' ' << i;
          EXPECT_NEAR(at->normal.norm(), 1.0, 1e-12);
        }
      }
      EXPECT_GT(found, 500);
    }
  }
}

/// No place of the triangle reaches above the cutter; the plane of contact holds all of it.
TEST(UprightTouch, ThePlaneOfContactIsBelowTheCutterEverywhere) {
  Random random(6);
  for (const auto& values : cutters) {
    const UprightTouch touch = touchOf(*makeProfile(values), 0.0);
    const UprightProfile& p = touch.profile();
    for (int i = 0; i < 2000; ++i) {
      const UprightFacet facet =
          facetOf(random.place(0.6, 0.2), random.place(0.6, 0.2), random.place(0.6, 0.2));
      const double s = random.in(-0.2, 0.2);
      const auto at = touch.of(facet, s);
      if (!at) {
        continue;
      }
      // What is above all tool ends that touch, by this normal alone.
      const Vec3& n = at->normal;
      double most = -1e9;
      for (const Vec3& c : facet.corners) {
        most = std::max(most, n.dot(c - Vec3(s, 0.0, 0.0)));
      }
      const double reach = p.support(n.z(), std::sqrt(std::max(0.0, 1.0 - n.z() * n.z())));
      EXPECT_NEAR((most + reach) / n.z(), at->z, 1e-9 / n.z());
    }
  }
}

/// Seen from farther left, the triangle is farther right; from the other side it is a mirror image.
TEST(UprightTouch, MovedAndMirroredTrianglesTouchAlike) {
  Random random(7);
  for (const auto& values : cutters) {
    const UprightTouch touch = touchOf(*makeProfile(values), 0.001);
    for (int i = 0; i < 500; ++i) {
      const Vec3 a = random.place(0.6, 0.2);
      const Vec3 b = random.place(0.6, 0.2);
      const Vec3 c = random.place(0.6, 0.2);
      const auto at = touch.of(facetOf(a, b, c), 0.1);
      const Vec3 moved(0.25, 0.0, 3.0);
      const auto other = touch.of(facetOf(a + moved, b + moved, c + moved), 0.35);
      const Vec3 over(1.0, -1.0, 1.0);
      const auto mirrored =
          touch.of(facetOf(a.cwiseProduct(over), b.cwiseProduct(over), c.cwiseProduct(over)), 0.1);
      ASSERT_EQ(at.has_value(), other.has_value());
      ASSERT_EQ(at.has_value(), mirrored.has_value());
      if (at) {
        EXPECT_NEAR(other->z, at->z + 3.0, 1e-10);
        EXPECT_NEAR(mirrored->z, at->z, 1e-10);
      }
    }
  }
}

TEST(UprightTouch, DrillsHaveNone) {
  EXPECT_FALSE(
      UprightProfile::of(*makeProfile(std::vector<double>{1, 0, 0.5, 0.1, 30, 0, 2}), 0.0));
  EXPECT_FALSE(UprightProfile::of(*makeProfile(cutters[0]), -0.6));
}

}  // namespace
}  // namespace arelem::tool
