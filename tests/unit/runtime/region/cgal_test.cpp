// Areas, validity and places against CGAL, which shares nothing with our code.
#include <cmath>
#include <random>

#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "runtime/region/region.h"

namespace arelem::region {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Polygon = CGAL::Polygon_2<Kernel>;

TEST(RegionAndCgal, AgreeOnRandomPolygons) {
  std::mt19937 random(11);
  int good = 0;
  int crossing = 0;
  for (int round = 0; round < 3000; ++round) {
    const int n = 3 + static_cast<int>(random() % 6);
    Corners corners;
    Polygon polygon;
    for (int i = 0; i < n; ++i) {
      // A coarse grid, so that corners and edges often meet exactly.
      const double x = static_cast<double>(random() % 7);
      const double y = static_cast<double>(random() % 7);
      corners.emplace_back(x, y, 0.0);
      polygon.push_back({x, y});
    }
    const Result<Region> region = regionOf({{Boundary::Role::outline, corners}});
    const bool repeats = [&] {
      for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i] == corners[(i + 1) % corners.size()]) {
          return true;  // we take a corner given twice in a row for one
        }
      }
      return false;
    }();
    if (repeats) {
      continue;
    }
    ASSERT_EQ(region.ok(), polygon.is_simple() && polygon.area() != 0) << round;
    region.ok() ? ++good : ++crossing;
    if (!region) {
      continue;
    }
    const spray::Outline outline = flattened(*region, 1.0).outline;
    EXPECT_NEAR(areaOf(outline), std::abs(CGAL::to_double(polygon.area())), 1e-12);
    for (int k = 0; k < 5; ++k) {
      const double x = static_cast<double>(random() % 700) / 100.0 + 0.005;
      const double y = static_cast<double>(random() % 700) / 100.0 + 0.003;
      const auto side = polygon.bounded_side({x, y});
      if (side != CGAL::ON_BOUNDARY) {
        EXPECT_EQ(isInside({x, y}, outline.loops[0]), side == CGAL::ON_BOUNDED_SIDE);
      }
    }
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(crossing, 100);
}

}  // namespace
}  // namespace arelem::region
