// Regions: what is refused, what is turned, how fast.
#include "runtime/region/region.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

namespace arelem::region {
namespace {

using Role = Boundary::Role;

Corners rectangle(double x, double y, double width, double height) {
  return {{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}};
}

std::string codeOf(std::vector<Boundary> boundaries) {
  const Result<Region> region = regionOf(std::move(boundaries));
  return region ? "" : std::string(region.failure().row->code);
}

TEST(Region, TurnsOutlinesAndHolesTheRightWayRound) {
  Corners outline = rectangle(0, 0, 10, 10);
  std::reverse(outline.begin(), outline.end());
  const Result<Region> region =
      regionOf({{Role::outline, outline}, {Role::hole, rectangle(4, 4, 2, 2)}});
  ASSERT_TRUE(region.ok());
  EXPECT_DOUBLE_EQ(areaOf(flattened(*region, 1.0).outline), 96.0);
  EXPECT_DOUBLE_EQ(areaOf(flattened(*region, 25.4).outline), 96.0 * 25.4 * 25.4);
}

TEST(Region, KeepsTheCoordinatesOfTheXyPlaneAndTheLengthsOfAny) {
  const Result<Region> flat = regionOf({{Role::outline, rectangle(3, 4, 10, 20)}});
  EXPECT_EQ(flattened(*flat, 1.0).outline.loops[0][0], spray::Vec2(3, 4));
  // The same, tilted by 30 degrees about x: the area stays.
  Corners tilted = rectangle(3, 4, 10, 20);
  for (Vec3& p : tilted) {
    p = {p.x(), p.y() * std::cos(0.5), p.y() * std::sin(0.5)};
  }
  const Result<Region> region = regionOf({{Role::outline, tilted}});
  ASSERT_TRUE(region.ok());
  EXPECT_GT(region->normal.z(), 0.0);
  const Flat laid = flattened(*region, 1.0);
  EXPECT_NEAR(areaOf(laid.outline), 200.0, 1e-9);
  EXPECT_NEAR((laid.frame.inSpace(laid.outline.loops[0][2]) - region->loops[0][2]).norm(), 0.0,
              1e-12);
}

TEST(Region, RefusesWhatIsNone) {
  EXPECT_EQ(codeOf({{Role::outline, {{0, 0, 0}, {1, 0, 0}}}}), "E0360");
  EXPECT_EQ(codeOf({{Role::outline, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 1}}}}), "E0361");
  EXPECT_EQ(codeOf({{Role::outline, {{0, 0, 0}, {9, 9, 0}, {9, 0, 0}, {0, 9, 0}}}}), "E0362");
  EXPECT_EQ(codeOf({{Role::outline, {{0, 0, 0}, {9, 0, 0}, {5, 0, 0}}}}), "E0364");
  EXPECT_EQ(codeOf({{Role::outline, rectangle(0, 0, 9, 9)}, {Role::hole, rectangle(20, 0, 5, 5)}}),
            "E0363");
  EXPECT_EQ(codeOf({{Role::outline, rectangle(0, 0, 9, 9)}, {Role::hole, rectangle(5, 5, 9, 9)}}),
            "E0362");
  EXPECT_EQ(
      codeOf({{Role::outline, rectangle(0, 0, 9, 9)}, {Role::outline, rectangle(2, 2, 5, 5)}}),
      "E0363");
  EXPECT_EQ(codeOf({{Role::outline, rectangle(0, 0, 9, 9)}, {Role::island, rectangle(2, 2, 5, 5)}}),
            "E0363");
  // A spike that turns back on itself, and an edge that touches another from inside.
  EXPECT_EQ(codeOf({{Role::outline,
                     {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 20, 0}, {9, 9, 0}, {0, 9, 0}}}}),
            "E0362");
  EXPECT_EQ(codeOf({{Role::outline, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {4, 0, 0}, {0, 9, 0}}}}),
            "E0362");
}

/// Circles of radius 50 about (0, 0) and (100, 0): cos and sin miss the common place by 1e-14.
TEST(Region, CirclesThatTouchAreRefused) {
  const auto circle = [](double x) {
    Corners corners;
    for (int i = 0; i < 40; ++i) {
      const double angle = 2.0 * M_PI * i / 40;
      corners.emplace_back(x + 50.0 * std::cos(angle), 50.0 * std::sin(angle), 0.0);
    }
    return corners;
  };
  EXPECT_EQ(codeOf({{Role::outline, circle(0.0)}, {Role::island, circle(100.0)}}), "E0362");
  EXPECT_EQ(codeOf({{Role::outline, circle(0.0)}, {Role::island, circle(100.001)}}), "");
}

TEST(Region, IslandsLieInHolesOrOutside) {
  EXPECT_EQ(codeOf({{Role::outline, rectangle(0, 0, 90, 90)},
                    {Role::hole, rectangle(10, 10, 60, 60)},
                    {Role::island, rectangle(20, 20, 10, 10)},
                    {Role::island, rectangle(200, 20, 10, 10)},
                    {Role::hole, rectangle(22, 22, 2, 2)}}),
            "");
}

TEST(Region, CanonicalNumbersReadBack) {
  const Region region =
      *regionOf({{Role::outline, rectangle(0, 0, 9, 9)}, {Role::hole, rectangle(2, 2, 3, 3)}});
  std::vector<double> canon = region.canon();
  EXPECT_TRUE(Region::readable(canon));
  EXPECT_EQ(Region::of(canon).canon(), canon);
  canon.pop_back();
  EXPECT_FALSE(Region::readable(canon));
  EXPECT_FALSE(Region::readable(std::vector<double>{0, 0, 1}));
}

TEST(Region, TenThousandCornersAndTwoHundredHoles) {
  Corners outline;
  constexpr int corners = 6000;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * i / corners;
    const double radius = 2000.0 + 20.0 * std::sin(37.0 * angle);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  std::vector<Boundary> boundaries = {{Role::outline, outline}};
  for (int i = 0; i < 200; ++i) {
    Corners hole;
    for (int k = 0; k < 20; ++k) {
      const double angle = 2.0 * M_PI * k / 20;
      hole.emplace_back(150.0 * (i % 20 - 9.5) * 0.8 + 40.0 * std::cos(angle),
                        150.0 * (i / 20 - 4.5) * 1.2 + 40.0 * std::sin(angle), 0.0);
    }
    boundaries.push_back({Role::hole, hole});
  }
  const auto begin = std::chrono::steady_clock::now();
  const Result<Region> region = regionOf(std::move(boundaries));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ASSERT_TRUE(region.ok()) << region.failure().message;
  EXPECT_EQ(region->loops.size(), 201U);
  EXPECT_LT(seconds, 20.0);
}

/// The corner that is lifted is named, not the first of those that lie well.
TEST(Region, NamesTheCornerThatIsOff) {
  for (std::size_t lifted = 0; lifted < 4; ++lifted) {
    Corners four = rectangle(0, 0, 100, 50);
    four[lifted].z() = 3.0;
    const Result<Region> region = regionOf({{Role::outline, four}});
    ASSERT_FALSE(region.ok());
    EXPECT_EQ(region.failure().row->code, "E0361");
    const std::string named =
        fmt::format("the corner ({:.9g}, {:.9g}, 3) is 3 off", four[lifted].x(), four[lifted].y());
    EXPECT_NE(region.failure().message.find(named), std::string::npos) << region.failure().message;
  }
}

TEST(Region, RefusesTheSameBoundaryTwiceAndWhatLiesTooFar) {
  Corners turned = rectangle(2, 2, 3, 3);
  std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  std::reverse(turned.begin(), turned.end());
  EXPECT_EQ(codeOf({{Role::outline, rectangle(0, 0, 10, 10)},
                    {Role::hole, rectangle(2, 2, 3, 3)},
                    {Role::hole, turned}}),
            "E0343");
  Corners far = rectangle(0, 0, 10, 10);
  far[1].x() = 1e300;
  EXPECT_EQ(codeOf({{Role::outline, far}}), "E0348");
}

}  // namespace
}  // namespace arelem::region
