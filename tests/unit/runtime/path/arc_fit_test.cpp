// Arcs and lines in the place of cut vectors: certified against the old path by dense samples.
#include "runtime/path/arc_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/path/arc_run.h"

namespace arelem::path {
namespace {

constexpr double band = 0.01;

cl::Record motionOf(const std::vector<Vec3>& points, cl::Motion::Kind kind) {
  cl::Motion motion;
  motion.kind = kind;
  for (const Vec3& p : points) {
    motion.coordinates.insert(motion.coordinates.end(), {p.x(), p.y(), p.z()});
  }
  return {1, "", {}, motion};
}

/// FROM the first point, the rest as one sequence, fitted with the whole band.
std::vector<cl::Record> fitted(const std::vector<Vec3>& points) {
  cl::Recording out;
  const auto fitter = makeArcFitter(out, 1.0);
  fitter->accept({1, "", {}, cl::Values{Word::OUTTOL, {band, band, band, band}}});
  fitter->accept(motionOf({points.front()}, cl::Motion::Kind::from));
  fitter->accept(motionOf({points.begin() + 1, points.end()}, cl::Motion::Kind::go));
  fitter->finish();
  return out.records;
}

std::vector<Vec3> locations(const std::vector<cl::Record>& records) {
  std::vector<Vec3> all;
  for (const cl::Record& record : records) {
    if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
      for (std::size_t i = 0; i < motion->coordinates.size(); i += 3) {
        all.emplace_back(&motion->coordinates[i]);
      }
    }
  }
  return all;
}

std::size_t surfaces(const std::vector<cl::Record>& records) {
  return static_cast<std::size_t>(std::count_if(records.begin(), records.end(), [](const auto& r) {
    return std::holds_alternative<cl::Surface>(r.body);
  }));
}

double toPolyline(const Vec3& p, const std::vector<Vec3>& line) {
  double least = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 d = line[i] - line[i - 1];
    const double s = std::clamp((p - line[i - 1]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - line[i - 1] - s * d).norm());
  }
  return least;
}

std::vector<Vec3> circle(int axis, double rise, int count) {
  std::vector<Vec3> points;
  for (int i = 0; i <= count; ++i) {
    const double a = 1.5 * std::numbers::pi * i / count;
    Vec3 p;
    p((axis + 1) % 3) = 7.0 + 30.0 * std::cos(a);
    p((axis + 2) % 3) = -3.0 + 30.0 * std::sin(a);
    p(axis) = 5.0 + rise * a;
    points.push_back(p);
  }
  return points;
}

TEST(ArcFit, CirclesAndHelicesInThreePlanes) {
  for (const int axis : {0, 1, 2}) {
    for (const double rise : {0.0, 2.0}) {
      const std::vector<Vec3> points = circle(axis, rise, 200);
      const auto records = fitted(points);
      ASSERT_EQ(surfaces(records), 1U) << axis << rise;
      for (const cl::Record& record : records) {
        if (const auto* surface = std::get_if<cl::Surface>(&record.body)) {
          EXPECT_NEAR(surface->surface.canon[6], 30.0, 1e-6);
          EXPECT_EQ(std::abs(surface->surface.canon[3 + static_cast<std::size_t>(axis)]), 1.0);
          EXPECT_NEAR(surface->surface.canon[static_cast<std::size_t>((axis + 1) % 3)], 7.0, 1e-6);
        }
      }
      const std::vector<Vec3> now = locations(records);
      for (const Vec3& p : now) {
        EXPECT_LE(toPolyline(p, points), band);
      }
      for (const Vec3& p : points) {
        EXPECT_LE(toPolyline(p, now), band);
      }
      // A chord of radius 30 whose middle is 0.005 off spans 2 acos(1 - 0.005/30) = 2.09 degrees:
      // 130 of them make 270 degrees.
      EXPECT_EQ(now.size(), 131U);
    }
  }
}

TEST(ArcFit, CollinearVectorsBecomeOne) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 100; ++i) {
    points.emplace_back(i, 0.5 * i + (i % 2 == 0 ? 0.001 : -0.001), 0.0);
  }
  const auto records = fitted(points);
  EXPECT_EQ(surfaces(records), 0U);
  EXPECT_LE(locations(records).size(), 3U);
  const auto now = locations(records);
  for (const Vec3& p : points) {
    EXPECT_LE(toPolyline(p, now), band);
  }
}

TEST(ArcFit, SquareKeepsItsCorners) {
  const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, 0, 0}};
  const auto records = fitted(points);
  EXPECT_EQ(surfaces(records), 0U);
  EXPECT_EQ(locations(records), points);
}

TEST(ArcFit, RapidMovesStay) {
  cl::Recording out;
  const auto fitter = makeArcFitter(out, 1.0);
  fitter->accept({1, "", {}, cl::Values{Word::OUTTOL, {band}}});
  fitter->accept(motionOf({{0, 0, 0}}, cl::Motion::Kind::from));
  fitter->accept({1, "", {}, cl::Post{Word::RAPID, "", {}}});
  fitter->accept(motionOf({{1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, cl::Motion::Kind::go));
  fitter->finish();
  EXPECT_EQ(locations(out.records).size(), 4U);
}

TEST(ArcFit, TurningBackIsNoLine) {
  const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {5, 0, 0}};
  EXPECT_FALSE(isStraight(points, 0.1));
}

}  // namespace
}  // namespace arelem::path
