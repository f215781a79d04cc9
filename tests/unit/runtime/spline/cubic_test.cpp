// Path splines against the source's cases, closed forms and each other.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::spline {
namespace {

constexpr double exact = 1e-12;

CubicSpline randomCurve(int seed, bool closed, std::size_t m = 9) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> step(0.3, 2.0);
  std::vector<Vec3> control(m);
  for (Vec3& p : control) {
    p = {place(random), place(random), place(random)};
  }
  std::vector<double> knots{0.5};
  while (knots.size() < (closed ? m + 1 : m - 2)) {
    knots.push_back(knots.back() + step(random));
  }
  return *CubicSpline::make(control, knots, closed);
}

TEST(CubicSpline, BezierPiecesOfTheSource) {
  const auto one = naseathCase("NAS-bspline-bezier");
  const auto curve = CubicSpline::make(pointsOf(one["inputs"]["P"]),
                                       one["inputs"]["k"].get<std::vector<double>>(), false);
  ASSERT_TRUE(curve.ok());
  const auto& pieces = one["expected"]["bez"];
  ASSERT_EQ(curve->spans(), pieces.size());
  for (std::size_t span = 0; span < pieces.size(); ++span) {
    const std::vector<Vec3> expected = pointsOf(pieces[span]);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((curve->piece(span).control[i] - expected[i]).norm(), exact);
    }
  }
  const std::vector<Vec3> at = pointsOf(one["expected"]["at"]);
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_LT((curve->at(curve->knots()[i]) - at[i]).norm(), exact);
  }
}

TEST(CubicSpline, StartCurvatureOfTheSource) {
  for (const char* id : {"NAS-curv36-0", "NAS-curv36-1", "NAS-curv36-2"}) {
    const auto one = naseathCase(id);
    const std::vector<Vec3> p = pointsOf(one["inputs"]["b"]);
    EXPECT_NEAR(startCurvatureInPlane({p[0], p[1], p[2], p[3]}), one["analytic"]["k"].get<double>(),
                exact);
    const auto curve = *CubicSpline::make(p, {0.0, 1.0}, false);
    EXPECT_NEAR(curve.curvature(0.0), std::abs(one["analytic"]["k"].get<double>()), exact);
  }
}

TEST(CubicSpline, ParametersOfTheSource) {
  const auto one = naseathCase("NAS-params");
  const auto knots = one["inputs"]["k"].get<std::vector<double>>();
  const auto curve = *CubicSpline::make(std::vector<Vec3>(6, Vec3::Zero()), knots, false);
  EXPECT_EQ(curve.begin(), 0.0);
  EXPECT_EQ(curve.end(), 5.0);
  EXPECT_EQ(curve.spans(), 3U);
}

TEST(CubicSpline, DerivativesAreDifferences) {
  for (const bool closed : {false, true}) {
    for (int seed = 0; seed < 20; ++seed) {
      const CubicSpline curve = randomCurve(seed, closed);
      const double t = curve.begin() + 0.37 * (curve.end() - curve.begin());
      const double h = 1e-4;
      const auto d = curve.derivatives(t);
      const Vec3 before = curve.at(t - h);
      const Vec3 after = curve.at(t + h);
      EXPECT_LT(((after - before) / (2.0 * h) - d.first).norm(), 1e-4 * (1.0 + d.first.norm()));
      EXPECT_LT(((after - 2.0 * d.point + before) / (h * h) - d.second).norm(),
                1e-2 * (1.0 + d.second.norm()));
    }
  }
}

TEST(CubicSpline, CurvatureIsContinuousAtKnots) {
  for (const bool closed : {false, true}) {
    const CubicSpline curve = randomCurve(3, closed);
    for (const double knot : curve.knots().subspan(1, curve.spans() - 1)) {
      EXPECT_NEAR(curve.curvature(knot - 1e-9), curve.curvature(knot + 1e-9), 1e-5);
    }
  }
}

TEST(CubicSpline, ClosedCurveGoesRound) {
  const CubicSpline curve = randomCurve(5, true);
  const double period = curve.end() - curve.begin();
  EXPECT_LT((curve.at(curve.begin()) - curve.at(curve.end())).norm(), 1e-11);
  EXPECT_LT((curve.at(1.7) - curve.at(1.7 + 3.0 * period)).norm(), 1e-10);
  const auto a = curve.derivatives(curve.begin());
  const auto b = curve.derivatives(curve.end() - 1e-12);
  EXPECT_LT((a.first - b.first).norm(), 1e-8);
  EXPECT_LT((a.second - b.second).norm(), 1e-8);
}

TEST(CubicSpline, KnotInsertionKeepsTheCurve) {
  for (const bool closed : {false, true}) {
    for (int seed = 0; seed < 20; ++seed) {
      const CubicSpline curve = randomCurve(seed, closed);
      const auto finer = curve.withKnot(curve.begin() + 0.61 * (curve.end() - curve.begin()));
      ASSERT_TRUE(finer.ok());
      const CubicSpline fine = curve.refined();
      EXPECT_EQ(finer->control().size(), curve.control().size() + 1);
      EXPECT_EQ(fine.spans(), 2 * curve.spans());
      std::vector<bool> marked(curve.spans(), false);
      marked.front() = marked.back() = true;
      const CubicSpline partly = curve.refined(marked);
      EXPECT_EQ(partly.spans(), curve.spans() + 2);
      for (int i = 0; i <= 100; ++i) {
        const double t = curve.begin() + i / 100.0 * (curve.end() - curve.begin());
        EXPECT_LT((curve.at(t) - finer->at(t)).norm(), 1e-11) << closed << ' ' << seed << ' ' << t;
        EXPECT_LT((curve.at(t) - fine.at(t)).norm(), 1e-11) << closed << ' ' << seed << ' ' << t;
        EXPECT_LT((curve.at(t) - partly.at(t)).norm(), 1e-11) << closed << ' ' << seed << ' ' << t;
      }
    }
  }
}

TEST(CubicSpline, NearestPointAgainstDenseSamples) {
  for (const bool closed : {false, true}) {
    for (int seed = 0; seed < 10; ++seed) {
      const CubicSpline curve = randomCurve(seed, closed);
      const Vec3 p = curve.control()[2] + Vec3(3.0, -1.0, 2.0);
      double least = 1e9;
      for (int i = 0; i <= 20000; ++i) {
        const double t = curve.begin() + i / 20000.0 * (curve.end() - curve.begin());
        least = std::min(least, (curve.at(t) - p).norm());
      }
      const auto found = curve.nearest(p);
      EXPECT_LE(found.distance, least + 1e-7);
      EXPECT_GE(found.distance, least - 1e-4);
      EXPECT_NEAR((curve.at(found.t) - p).norm(), found.distance, 1e-7);
    }
  }
}

TEST(CubicSpline, LengthOfAStraightCurve) {
  const auto curve = *CubicSpline::uniform({{0, 0, 0}, {1, 2, 2}, {2, 4, 4}, {3, 6, 6}}, false);
  EXPECT_NEAR(curve.length(), 9.0, exact);
  EXPECT_NEAR(curve.curvature(0.3), 0.0, exact);
}

TEST(CubicSpline, ChordsKeepTheTolerance) {
  const CubicSpline curve = randomCurve(11, false);
  for (const double tolerance : {0.5, 0.01, 1e-4}) {
    const std::vector<Vec3> points = chordPoints(curve, tolerance);
    double most = 0.0;
    for (int i = 0; i <= 3000; ++i) {
      const double t = curve.begin() + i / 3000.0 * (curve.end() - curve.begin());
      double least = 1e9;
      for (std::size_t k = 1; k < points.size(); ++k) {
        least = std::min(least, distanceToSegment(curve.at(t), points[k - 1], points[k]));
      }
      most = std::max(most, least);
    }
    EXPECT_LE(most, tolerance);
    EXPECT_GT(most, 0.05 * tolerance);
  }
}

TEST(CubicSpline, CanonicalNumbersReadBack) {
  for (const bool closed : {false, true}) {
    const CubicSpline curve = randomCurve(2, closed);
    const auto back = CubicSpline::of(curve.canon());
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->canon(), curve.canon());
  }
}

TEST(CubicSpline, WrongInputIsRefused) {
  const std::vector<Vec3> four(4, Vec3::Ones());
  const auto code = [](const Result<CubicSpline>& r) {
    return r ? std::string("ok") : std::string(r.failure().row->code);
  };
  EXPECT_EQ(code(CubicSpline::make({four.begin(), four.begin() + 3}, {0, 1}, false)), "E0380");
  EXPECT_EQ(code(CubicSpline::make(four, {0, 1, 2}, false)), "E0381");
  EXPECT_EQ(code(CubicSpline::make(four, {1, 1}, false)), "E0382");
  EXPECT_EQ(code(CubicSpline::make(four, {0, std::nan("")}, false)), "E0382");
  EXPECT_EQ(code(interpolate(four, false)), "E0383");
  EXPECT_EQ(code(interpolate({}, false)), "E0380");
  EXPECT_EQ(code(CubicSpline::of(std::vector<double>{0, 4, 0, 1})), "E0385");
}

TEST(CubicSpline, Cusps) {
  const auto uniform = [](std::vector<Vec3> control) {
    return *CubicSpline::uniform(std::move(control), false);
  };
  // There and back on a line: the derivative changes its sign half way, by symmetry.
  const auto back = cuspOf(uniform({{0, 0, 0}, {8, 0, 0}, {8.5, 0, 0}, {0.5, 0, 0}}));
  ASSERT_TRUE(back.has_value());
  // p' is 3 (8 (1-t)^2 + 2 t (1-t) 0.5 - 8 t^2), 0 at t = 8.5 +- ... : 8 - 15 t - t^2 = 0.
  EXPECT_NEAR(*back, (-15.0 + std::sqrt(225.0 + 32.0)) / 2.0, 1e-9);
  // The cubic (t^2, t^3) in Bezier form over [-1, 1]: the cusp at its middle.
  EXPECT_NEAR(*cuspOf(uniform({{1, -1, 0}, {-1.0 / 3, 1, 0}, {-1.0 / 3, -1, 0}, {1, 1, 0}})), 0.5,
              1e-9);
  // A hairpin is none, however narrow.
  EXPECT_FALSE(cuspOf(uniform({{0, 0, 0}, {8, 0, 0}, {8, 1e-6, 0}, {0, 1e-6, 0}})).has_value());
  EXPECT_FALSE(cuspOf(uniform({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}})).has_value());
}

}  // namespace
}  // namespace arelem::spline
