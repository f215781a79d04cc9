// Areas, validity and places of random polygons on a coarse grid, where corners and edges often
// meet exactly, against whole numbers: nothing here is rounded, and nothing is CGAL's.
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "runtime/geometry/exact_polygon.h"
#include "runtime/geometry/nesting.h"
#include "runtime/region/region.h"

namespace arelem::region {
namespace {

using Place = std::array<long, 2>;
using Places = std::vector<Place>;

/// Twice the area of a triangle: positive where it turns to the left.
long twice(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool onSegment(const Place& p, const Place& a, const Place& b) {
  return twice(a, b, p) == 0 && std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}

int sign(long value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

bool cross(const Place& a, const Place& b, const Place& c, const Place& d) {
  const bool proper = sign(twice(a, b, c)) * sign(twice(a, b, d)) < 0 &&
                      sign(twice(c, d, a)) * sign(twice(c, d, b)) < 0;
  return proper || onSegment(c, a, b) || onSegment(d, a, b) || onSegment(a, c, d) ||
         onSegment(b, c, d);
}

/// Whether edges meet only where neighbors share a corner.
bool simple(const Places& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      const Place& a = p[i];
      const Place& b = p[(i + 1) % n];
      const Place& c = p[k];
      const Place& d = p[(k + 1) % n];
      const bool neighbors = k == i + 1 || (i == 0 && k == n - 1);
      const bool bad = !neighbors   ? cross(a, b, c, d)
                       : n == 3     ? twice(p[0], p[1], p[2]) == 0
                       : k == i + 1 ? onSegment(d, a, b) || onSegment(a, c, d)
                                    : onSegment(c, a, b) || onSegment(b, c, d);
      if (bad) {
        return false;
      }
    }
  }
  return true;
}

long twiceArea(const Places& p) {
  long sum = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    sum += twice(p[0], p[i], p[i + 1]);
  }
  return sum;
}

/// By the crossings of a ray to the right; not for places on the border.
bool inside(const Place& p, const Places& polygon) {
  bool in = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Place& a = polygon[i];
    const Place& b = polygon[(i + 1) % polygon.size()];
    if ((a[1] <= p[1]) != (b[1] <= p[1])) {
      in = in != ((b[1] > a[1]) == (twice(a, b, p) > 0));
    }
  }
  return in;
}

TEST(Region, OfRandomCorners) {
  std::mt19937 random(11);
  int good = 0;
  int crossing = 0;
  for (int round = 0; round < 3000; ++round) {
    const int n = 3 + static_cast<int>(random() % 6);
    Places places;
    Corners corners;
    while (static_cast<int>(places.size()) < n) {
      const Place p = {100 * static_cast<long>(random() % 7),
                       100 * static_cast<long>(random() % 7)};
      const bool last = static_cast<int>(places.size()) + 1 == n;
      if (!places.empty() && (p == places.back() || (last && p == places.front()))) {
        continue;  // a corner given twice in a row is taken for one
      }
      places.push_back(p);
      corners.emplace_back(static_cast<double>(p[0]), static_cast<double>(p[1]), 0.0);
    }
    const Result<Region> region = regionOf({{Boundary::Role::outline, corners}});
    ASSERT_EQ(region.ok(), simple(places)) << round;
    region.ok() ? ++good : ++crossing;
    if (!region) {
      continue;
    }
    const spray::Outline outline = flattened(*region, 1.0).outline;
    EXPECT_EQ(2.0 * areaOf(outline), static_cast<double>(std::abs(twiceArea(places))));
    for (int k = 0; k < 5; ++k) {
      const Place p = {static_cast<long>(random() % 700), static_cast<long>(random() % 700)};
      bool border = false;
      for (std::size_t i = 0; i < places.size(); ++i) {
        border = border || onSegment(p, places[i], places[(i + 1) % places.size()]);
      }
      if (border) {
        continue;
      }
      // No edge passes nearer to a place of the grid than 1 / 1000: a speck there is off all.
      const spray::Vec2 place(static_cast<double>(p[0]), static_cast<double>(p[1]));
      const spray::Vec2 right = place + spray::Vec2(1e-4, 0);
      const spray::Vec2 above = place + spray::Vec2(0, 1e-4);
      const std::vector<geometry::Polygon> both = {outline.loops[0], {place, right, above}};
      EXPECT_EQ(geometry::nestingDepths(both),
                (std::vector<std::size_t>{0, inside(p, places) ? 1U : 0U}));
    }
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(crossing, 100);
}

/// The first pair in the order of the corners is told, wherever else edges meet.
TEST(Region, TellsTheFirstCrossing) {
  // Two bow ties in one boundary: edges 0 and 2 cross at (5, 5), others farther on.
  const std::vector<geometry::Polygon> bow = {
      {{0, 0}, {10, 10}, {10, 0}, {0, 10}, {-10, 30}, {10, 20}, {10, 30}, {-10, 20}}};
  const auto meeting = geometry::firstMeeting(bow);
  ASSERT_TRUE(meeting);
  EXPECT_EQ(std::pair(meeting->edge, meeting->otherEdge),
            std::pair(std::size_t{0}, std::size_t{2}));
  EXPECT_EQ(meeting->place, spray::Vec2(5, 5));
}

/// One part in 2^52 decides: 0.1 + 0.2 lies beyond 0.3.
TEST(Region, SignsAreExact) {
  const double beyond = 0.1 + 0.2;
  const std::vector<geometry::Polygon> touching = {{{0, 0}, {0.3, 0}, {0.3, 1}, {0, 1}},
                                                   {{0.3, 0.5}, {1, 0}, {1, 1}}};
  std::vector<geometry::Polygon> apart = touching;
  apart[1][0].x() = beyond;
  EXPECT_TRUE(geometry::firstMeeting(touching));
  EXPECT_FALSE(geometry::firstMeeting(apart));
}

/// Squares around one middle, each in the one before, given inside out and turned either way;
/// beside them a comb whose teeth hold one more square each.
TEST(Region, DepthOfNestedPolygons) {
  std::vector<geometry::Polygon> polygons;
  std::vector<std::size_t> depths;
  for (int k = 1; k <= 50; ++k) {
    const double h = k;
    polygons.push_back({{-h, -h}, {h, -h}, {h, h}, {-h, h}});
    if (k % 3 == 0) {
      std::reverse(polygons.back().begin(), polygons.back().end());
    }
    depths.push_back(static_cast<std::size_t>(50 - k));
  }
  geometry::Polygon comb = {{100, 0}, {500, 0}};
  for (int tooth = 99; tooth >= 0; --tooth) {
    const double x = 100 + 4 * tooth;
    comb.insert(comb.end(), {{x + 3, 90}, {x + 1, 90}, {x + 1, 10}, {x, 10}});
    const double y = tooth % 2 == 0 ? 50 : 5;  // in a tooth, or between the teeth's feet and below
    polygons.push_back({{x + 1.5, y}, {x + 2, y}, {x + 2, y + 1}});
    depths.push_back(1);
    polygons.push_back({{x + 0.2, 50}, {x + 0.8, 50}, {x + 0.5, 51}});  // in a gap
    depths.push_back(0);
  }
  polygons.push_back(comb);
  depths.push_back(0);
  ASSERT_FALSE(geometry::firstMeeting(polygons));
  EXPECT_EQ(geometry::nestingDepths(polygons), depths);
}

}  // namespace
}  // namespace arelem::region
