// Curves through and along points.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::spline {
namespace {

TEST(SplineFit, CasesFiveAndSixOfTheSource) {
  for (const int which : {5, 6}) {
    const auto expected = naseathCase("NAS-c" + std::to_string(which) + "-spline")["expected"];
    const CubicSpline curve = naseathSpline(which);
    const std::vector<Vec3> control = pointsOf(expected["ctrl"]);
    ASSERT_EQ(curve.control().size(), control.size());
    for (std::size_t i = 0; i < control.size(); ++i) {
      EXPECT_LT((curve.control()[i] - control[i]).norm(), 1e-9);
    }
    EXPECT_NEAR(curve.length(), expected["length"].get<double>(), 1e-3);
  }
}

TEST(SplineFit, InterpolationPassesEveryPoint) {
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) {
    points.emplace_back(10.0 * std::cos(i * 0.5), 10.0 * std::sin(i * 0.5), 0.3 * i);
  }
  for (const bool closed : {false, true}) {
    const auto curve = interpolate(points, closed);
    ASSERT_TRUE(curve.ok());
    for (const Vec3& p : points) {
      EXPECT_LT(curve->nearest(p).distance, 1e-7);
    }
  }
  const auto open = interpolate(points, false);
  EXPECT_NEAR(open->curvature(open->begin()), 0.0, 1e-9);
}

/// Largest distance of the curve from the polyline, by dense samples.
double distanceFrom(const CubicSpline& curve, const std::vector<Vec3>& points, bool closed) {
  double most = 0.0;
  for (int i = 0; i <= 5000; ++i) {
    const Vec3 p = curve.at(curve.begin() + i / 5000.0 * (curve.end() - curve.begin()));
    double least = 1e9;
    for (std::size_t k = closed ? 0 : 1; k < points.size(); ++k) {
      const Vec3& before = points[(k + points.size() - 1) % points.size()];
      least = std::min(least, distanceToSegment(p, before, points[k]));
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(SplineFit, PolylineIsFollowedWithinTheTolerance) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-20.0, 20.0);
  for (int round = 0; round < 20; ++round) {
    std::vector<Vec3> points(8);
    for (Vec3& p : points) {
      p = {place(random), place(random), place(random)};
    }
    for (const bool closed : {false, true}) {
      for (const double tolerance : {1.0, 0.01}) {
        const auto curve = followPolyline(points, tolerance, closed);
        ASSERT_TRUE(curve.ok());
        EXPECT_LE(distanceFrom(*curve, points, closed), tolerance * (1.0 + 1e-9));
        for (const Vec3& p : points) {
          EXPECT_LE(curve->nearest(p).distance, tolerance * (1.0 + 1e-6));
        }
      }
    }
  }
}

TEST(SplineFit, TwoPointsAreALine) {
  const std::vector<Vec3> points{{0, 0, 0}, {3, 4, 0}};
  const auto curve = followPolyline(points, 0.1, false);
  ASSERT_TRUE(curve.ok());
  EXPECT_NEAR(curve->length(), 5.0, 1e-12);
  EXPECT_LT((curve->at(curve->end()) - points[1]).norm(), 1e-12);
}

TEST(SplineFit, LeastSquaresNeedFewControlPoints) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 1000; ++i) {
    const double a = i * 0.003;
    points.emplace_back(50.0 * std::cos(a), 50.0 * std::sin(a), 5.0 * a);
  }
  const auto curve = approximate(points, 0.001);
  ASSERT_TRUE(curve.ok());
  EXPECT_LT(curve->control().size(), 40U);
  for (const Vec3& p : points) {
    EXPECT_LE(curve->nearest(p).distance, 0.001);
  }
}

TEST(SplineFit, LeastSquaresGoRound) {
  std::vector<Vec3> points;
  for (int i = 0; i < 720; ++i) {
    const double a = i * std::numbers::pi / 360.0;
    points.emplace_back(50.0 * std::cos(a), 30.0 * std::sin(a), 0.0);
  }
  const auto curve = approximate(points, 0.01, true);
  ASSERT_TRUE(curve.ok());
  EXPECT_TRUE(curve->closed());
  EXPECT_LT(curve->control().size(), 40U);
  for (const Vec3& p : points) {
    EXPECT_LE(curve->nearest(p).distance, 0.01);
  }
  // Ramanujan's perimeter of an ellipse of 50 and 30.
  EXPECT_NEAR(curve->length(), 255.27, 0.05);
  // Four points through which nothing smooth of four control points goes: interpolated.
  const std::vector<Vec3> few{{0, 0, 0}, {9, 0, 0}, {9, 1, 0}, {0, 1, 0}, {-3, .5, 0}};
  const auto exact = approximate(few, 1e-9, true);
  ASSERT_TRUE(exact.ok());
  for (const Vec3& p : few) {
    EXPECT_LE(exact->nearest(p).distance, 1e-9);
  }
  EXPECT_FALSE(approximate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, 0.1, true).ok());
}

TEST(SplineFit, CoincidentPointsAreRefused) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(followPolyline(points, 0.1, false).ok());
  EXPECT_FALSE(approximate(points, 0.1).ok());
}

}  // namespace
}  // namespace arelem::spline
