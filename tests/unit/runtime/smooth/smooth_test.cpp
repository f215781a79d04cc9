// SMOOTH against the source's cases, and both methods against each other.
#include "runtime/smooth/smooth.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "bench/smoothing/source_inputs.h"
#include "runtime/smooth/banded.h"
#include "runtime/smooth/polygon.h"
#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::smooth {
namespace {

using spline::CubicSpline;
using spline::naseathCase;
using spline::naseathSpline;
using spline::pointsOf;

TEST(NaseathPolygon, Categories) {
  for (const char* id :
       {"NAS-cat-ripple", "NAS-cat-smooth", "NAS-cat-line", "NAS-cat-four", "NAS-cat-two-arcs"}) {
    const auto one = naseathCase(id);
    const Categories found = categories(pointsOf(one["inputs"]["P"]), false);
    EXPECT_EQ(found.letters(), one["expected"]["cat"].get<std::string>()) << id;
    if (!one["expected"].contains("groups")) {
      continue;
    }
    const auto& groups = one["expected"]["groups"];
    ASSERT_EQ(found.groups.size(), groups.size()) << id;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      EXPECT_EQ(found.groups[g].first, groups[g].front().get<std::size_t>()) << id;
      EXPECT_EQ(found.groups[g].last, groups[g].back().get<std::size_t>()) << id;
    }
  }
}

TEST(NaseathPolygon, Directions) {
  for (const char* id : {"NAS-dir-ripple", "NAS-dir-arc-odd", "NAS-dir-arc-even"}) {
    const auto one = naseathCase(id);
    const std::vector<Vec3> points = pointsOf(one["inputs"]["P"]);
    const std::vector<Vec3> expected = pointsOf(one["expected"]["DV"]);
    const auto found = directions(points, points, categories(points, false), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT((found[i] - expected[i]).norm(), 1e-9) << id << ' ' << i;
    }
  }
}

TEST(NaseathPolygon, DirectionsTurnWithThePolygon) {
  const std::vector<Vec3> flat = pointsOf(naseathCase("NAS-dir-arc-even")["inputs"]["P"]);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  std::vector<Vec3> turned;
  for (const Vec3& p : flat) {
    turned.push_back(turn * p + Vec3(5, 6, 7));
  }
  const auto plain = directions(flat, flat, categories(flat, false), false);
  const auto found = directions(turned, turned, categories(turned, false), false);
  EXPECT_EQ(categories(flat, false).letters(), categories(turned, false).letters());
  for (std::size_t i = 0; i < flat.size(); ++i) {
    EXPECT_LT((found[i] - turn * plain[i]).norm(), 1e-9);
  }
}

TEST(NaseathPolygon, Moves) {
  const auto one = naseathCase("NAS-sens");
  const auto found = moves(one["inputs"]["S"].get<std::vector<double>>(), 10.0);
  const auto expected = one["expected"]["move"].get<std::vector<double>>();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-12);
  }
}

/// Largest distance at equal parameters, sampled.
double sampledDeviation(const CubicSpline& a, const CubicSpline& b) {
  double most = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double t = a.begin() + i / 4000.0 * (a.end() - a.begin());
    most = std::max(most, (a.at(t) - b.at(t)).norm());
  }
  return most;
}

TEST(SourceMethod, CasesFiveAndSix) {
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    for (const char* radius : {"0.025", "0.125", "0.25"}) {
      const auto one = naseathCase("NAS-c" + std::to_string(which) + "-R" + radius);
      const auto& expected = one["expected"];
      const auto& allowed = one["tolerance"];
      Options options;
      options.tolerance = std::stod(radius);
      options.method = Method::source;
      const auto result = smooth(curve, options);
      ASSERT_TRUE(result.ok());
      EXPECT_EQ(result->iterations, expected["iterations"].get<int>());
      EXPECT_NEAR(result->curve.length(), expected["length"].get<double>(),
                  allowed["length"].get<double>());
      EXPECT_NEAR(curvatureFigures(result->curve, 50).most, expected["curv_max"].get<double>(),
                  allowed["curv_max"].get<double>());
      EXPECT_LE(result->deviation, options.tolerance);
      EXPECT_LE(sampledDeviation(curve, result->curve), options.tolerance);
      EXPECT_GT(sampledDeviation(curve, result->curve), 0.9 * options.tolerance);
    }
  }
}

TEST(TubeMethod, CurvesLessThanTheSource) {
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    for (const double radius : {0.025, 0.125, 0.25}) {
      Options options;
      options.tolerance = radius;
      options.method = Method::source;
      const auto source = smooth(curve, options);
      options.method = Method::tube;
      const auto tube = smooth(curve, options);
      ASSERT_TRUE(source.ok() && tube.ok());
      EXPECT_LT(curvatureFigures(tube->curve, 20).most, curvatureFigures(source->curve, 20).most);
      EXPECT_LE(tube->deviation, radius);
      EXPECT_LE(sampledDeviation(curve, tube->curve), radius);
    }
  }
}

CubicSpline wavyRing(std::size_t m) {
  std::vector<Vec3> control;
  for (std::size_t i = 0; i < m; ++i) {
    const double a = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(m);
    const double r = 20.0 + (i % 2 == 0 ? 0.4 : -0.4);
    control.emplace_back(r * std::cos(a), r * std::sin(a), 2.0 * std::sin(3.0 * a));
  }
  return *CubicSpline::uniform(control, true);
}

TEST(BothMethods, ClosedSpatialRing) {
  for (const std::size_t m : {std::size_t{6}, std::size_t{30}}) {
    const CubicSpline curve = wavyRing(m);
    for (const Method method : {Method::source, Method::tube}) {
      Options options;
      options.tolerance = 0.1;
      options.method = method;
      const auto result = smooth(curve, options);
      ASSERT_TRUE(result.ok());
      if (method == Method::tube || m > 6) {  // the source promises nothing for so few points
        EXPECT_LT(curvatureFigures(result->curve, 20).most, curvatureFigures(curve, 20).most);
      }
      EXPECT_LE(sampledDeviation(curve, result->curve), 0.1);
      EXPECT_LT((result->curve.at(curve.begin()) - result->curve.at(curve.end())).norm(), 1e-9);
    }
  }
}

/// Knots that know nothing of the distances between the points: the curve makes loops, about which the
/// convex problems lead far away.
TEST(BothMethods, LoopsDoNotLeadAway) {
  std::vector<Vec3> points;
  for (int i = 0; i < 28; ++i) {
    points.emplace_back(3.7 * i, 0.0, 0.0);
    if (i == 9 || i == 18) {
      points.emplace_back(3.7 * i + 0.25, 0.2, 0.0);
    }
  }
  const CubicSpline loops = source::through(points, 0.0);
  for (const double radius : {0.025, 0.125, 0.25, 2.0}) {
    for (const Method method : {Method::source, Method::tube, Method::time}) {
      const auto found = smooth(loops, {.tolerance = radius, .method = method});
      ASSERT_TRUE(found.ok());
      EXPECT_TRUE(std::isfinite(found->curve.length()));
      EXPECT_LE(found->deviation, radius);
      for (double t = 0.0; t < loops.end(); t += 0.1) {
        EXPECT_LE((found->curve.at(t) - loops.at(t)).norm(), radius * (1.0 + 1e-9));
      }
    }
  }
}

TEST(BothMethods, StraightPathStays) {
  const auto curve =
      *CubicSpline::uniform({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}, false);
  for (const Method method : {Method::source, Method::tube}) {
    Options options;
    options.tolerance = 0.1;
    options.method = method;
    const auto result = smooth(curve, options);
    ASSERT_TRUE(result.ok());
    EXPECT_LT(sampledDeviation(curve, result->curve), 1e-9);
  }
}

TEST(BothMethods, WrongSettingsAreRefused) {
  const auto curve = wavyRing(8);
  for (const double tolerance : {0.0, -1.0, std::nan("")}) {
    Options options;
    options.tolerance = tolerance;
    EXPECT_EQ(smooth(curve, options).failure().row->code, "E0390");
  }
  Options options;
  options.tolerance = 1.0;
  options.precision = 0;
  EXPECT_EQ(smooth(curve, options).failure().row->code, "E0391");
}

TEST(BandedSystem, SolvesAsADenseOne) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (const bool closed : {false, true}) {
    for (const std::size_t points : {std::size_t{5}, std::size_t{7}, std::size_t{14}}) {
      const auto n = static_cast<Eigen::Index>(points);
      BandedSystem system(points, closed);
      Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(n, n);
      for (std::size_t span = 0; span + (closed ? 0 : 3) < points; ++span) {
        const std::array<double, 4> row{value(random), value(random), value(random), value(random)};
        for (std::size_t i = 0; i < 4; ++i) {
          for (std::size_t k = i; k < 4; ++k) {
            system.add((span + i) % points, k - i, row[i] * row[k]);
          }
          for (std::size_t k = 0; k < 4; ++k) {
            dense(static_cast<Eigen::Index>((span + i) % points),
                  static_cast<Eigen::Index>((span + k) % points)) += row[i] * row[k];
          }
        }
      }
      for (std::size_t i = 0; i < points; ++i) {
        system.add(i, 0, 0.5);
      }
      dense += 0.5 * Eigen::MatrixXd::Identity(n, n);
      system.factor();
      std::vector<Vec3> x(points);
      Eigen::MatrixXd right(n, 3);
      for (Eigen::Index i = 0; i < n; ++i) {
        x[static_cast<std::size_t>(i)] = {value(random), value(random), value(random)};
        right.row(i) = x[static_cast<std::size_t>(i)].transpose();
      }
      system.solve(x);
      const Eigen::MatrixXd expected = dense.ldlt().solve(right);
      for (Eigen::Index i = 0; i < n; ++i) {
        EXPECT_LT((x[static_cast<std::size_t>(i)] - expected.row(i).transpose()).norm(), 1e-9)
            << closed << points;
      }
    }
  }
}

CubicSpline longWave(std::size_t m, bool closed) {
  std::vector<Vec3> control;
  for (std::size_t i = 0; i < m; ++i) {
    const double a = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(m);
    const double r = 0.1 * static_cast<double>(m) + std::sin(0.9 * static_cast<double>(i));
    control.emplace_back(r * std::cos(a), r * std::sin(a), std::cos(0.7 * static_cast<double>(i)));
  }
  return *CubicSpline::uniform(control, closed);
}

/// Windows meet without a trace: the largest curvature of the long path falls as that of a path
/// that fits into one window, and the ends of an open path stay.
TEST(AllMethods, LongPathsAreAsSmoothAsShortOnes) {
  for (const bool closed : {false, true}) {
    for (const Method method : {Method::source, Method::tube, Method::time}) {
      Options options;
      options.tolerance = 0.3;
      options.method = method;
      const CubicSpline brief = longWave(200, closed);
      const CubicSpline curve = longWave(2500, closed);
      const auto few = smooth(brief, options);
      const auto many = smooth(curve, options);
      ASSERT_TRUE(few.ok() && many.ok());
      const double left = curvatureFigures(few->curve, 6).most / curvatureFigures(brief, 6).most;
      EXPECT_LT(curvatureFigures(many->curve, 6).most / curvatureFigures(curve, 6).most,
                1.25 * left)
          << closed << static_cast<int>(method);
      EXPECT_LE(sampledDeviation(curve, many->curve), options.tolerance);
      EXPECT_LE(many->deviation, options.tolerance);
      if (!closed && method != Method::source) {
        EXPECT_EQ(many->curve.control().front(), curve.control().front());
        EXPECT_EQ(many->curve.control().back(), curve.control().back());
      }
    }
  }
}

}  // namespace
}  // namespace arelem::smooth
