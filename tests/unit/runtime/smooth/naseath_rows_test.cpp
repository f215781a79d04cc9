// Every row of cases_naseath.json: an assertion, or the reason why there is none. A row of a
// function that is not known here fails.
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include <gtest/gtest.h>

#include "bench/smoothing/source_time.h"
#include "runtime/smooth/polygon.h"
#include "runtime/smooth/smooth.h"
#include "runtime/timing/spline_limits.h"
#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::smooth {
namespace {

using nlohmann::json;
using spline::CubicSpline;
using spline::naseathCase;
using spline::naseathSpline;
using spline::pointsOf;
using Numbers = std::vector<double>;

constexpr int samples = 5;

void expectNear(const Numbers& found, const json& expected, double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i].get<double>(), tolerance) << i;
  }
}

Smoothed bySource(const CubicSpline& curve, double radius) {
  Options options;
  options.tolerance = radius;
  options.method = Method::source;
  return *smooth(curve, options);
}

double percent(double before, double after) {
  return 100.0 * (before - after) / before;
}

/// Largest curvature of a curvature-limited speed, and back.
void speedLimits(const json& row) {
  const json& in = row["inputs"];
  const double acceleration = in["A"].get<double>();
  if (in.contains("V")) {
    EXPECT_NEAR(timing::curveSpeed(row["expected"]["k"].get<double>(), acceleration),
                in["V"].get<double>(), 1e-9);
  } else {
    EXPECT_NEAR(timing::curveSpeed(in["k"].get<double>(), acceleration),
                row["expected"]["v"].get<double>(), 1e-9);
  }
}

void sensitivity(const json& row) {
  const auto s = row["inputs"]["S"].get<Numbers>();
  const double distance = row["inputs"]["D"].get<double>();
  const Numbers found = moves(s, distance);
  Numbers inverse, scaled, change;
  for (std::size_t i = 0; i < s.size(); ++i) {
    scaled.push_back(found[i] / distance);
    inverse.push_back(scaled.back() / s.front());
    change.push_back(found[i] * s[i]);
  }
  expectNear(found, row["expected"]["move"], 1e-12);
  expectNear(scaled, row["expected"]["scaled"], 1e-12);
  expectNear(inverse, row["expected"]["inv"], 1e-12);
  expectNear(change, row["expected"]["spline"], 1e-12);
}

/// The weights are the places of Bezier curves with one control point at 1 and the others at 0.
void bernstein(const json& row) {
  Numbers found;
  for (std::size_t i = 0; i < 4; ++i) {
    spline::Bezier piece;
    piece.control.fill(Vec3::Zero());
    piece.control[i] = Vec3::UnitX();
    found.push_back(piece.at(row["inputs"]["t"].get<double>()).x());
  }
  expectNear(found, row["expected"]["m"], 1e-12);
}

void startCurvature(const json& row) {
  const std::vector<Vec3> p = pointsOf(row["inputs"]["b"]);
  EXPECT_NEAR(spline::startCurvatureInPlane({p[0], p[1], p[2], p[3]}),
              row["expected"]["k"].get<double>(), 1e-12);
}

/// The right normal of a direction is where an end with its neighbors on that side moves.
void offset(const json& row) {
  const auto p = row["inputs"]["p"].get<std::array<double, 2>>();
  const auto d = row["inputs"]["d"].get<std::array<double, 2>>();
  const Vec3 end(p[0], p[1], 0.0);
  const Vec3 along(d[0], d[1], 0.0);
  const Vec3 right(d[1], -d[0], 0.0);
  const std::vector<Vec3> polygon{end, end + along, end + 2.0 * along - 0.5 * right,
                                  end + 3.0 * along, end + 4.0 * along};
  const Categories found = categories(polygon, false);
  const Vec3 moved =
      end + row["inputs"]["rho"].get<double>() * directions(polygon, polygon, found, false)[0];
  expectNear({moved.x(), moved.y()}, row["expected"]["q"], 1e-12);
}

/// One control point moved: the curve changes most at the parameter where it acts.
void actingPlaces(const json& row) {
  const auto knots = row["inputs"]["k"].get<Numbers>();
  const auto expected = row["expected"]["t"].get<Numbers>();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    std::vector<Vec3> control(expected.size(), Vec3::Zero());
    control[i] = Vec3::UnitX();
    const CubicSpline change = *CubicSpline::make(control, knots, false);
    const double there = change.at(expected[i]).x();
    EXPECT_GT(there, 0.4) << i;
    for (int k = 0; k <= 100; ++k) {
      EXPECT_GE(there, 0.8 * change.at(k / 100.0 * knots.back()).x()) << i;
    }
  }
}

void toBezier(const json& row) {
  const auto curve =
      *CubicSpline::make(pointsOf(row["inputs"]["P"]), row["inputs"]["k"].get<Numbers>(), false);
  const json& pieces = row["expected"]["bez"];
  ASSERT_EQ(curve.spans(), pieces.size());
  for (std::size_t span = 0; span < pieces.size(); ++span) {
    const std::vector<Vec3> expected = pointsOf(pieces[span]);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT((curve.piece(span).control[i] - expected[i]).norm(), 1e-9);
    }
  }
}

void polygonCategories(const json& row) {
  const Categories found = categories(pointsOf(row["inputs"]["P"]), false);
  EXPECT_EQ(found.letters(), row["expected"]["cat"].get<std::string>());
  const json groups = row["expected"].value("groups", json());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    ASSERT_LT(g, found.groups.size());
    EXPECT_EQ(found.groups[g].first, groups[g].front().get<std::size_t>());
    EXPECT_EQ(found.groups[g].last, groups[g].back().get<std::size_t>());
  }
}

void polygonDirections(const json& row) {
  const std::vector<Vec3> points = pointsOf(row["inputs"]["P"]);
  const std::vector<Vec3> expected = pointsOf(row["expected"]["DV"]);
  const auto found = directions(points, points, categories(points, false), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((found[i] - expected[i]).norm(), 1e-9) << i;
  }
}

void changeOfSpeed(const json& row) {
  const json& in = row["inputs"];
  const timing::Transition change(in["v0"].get<double>(), in["v1"].get<double>(),
                                  {400.0, in["A"].get<double>(), in["J"].get<double>()});
  const json& expected = row["expected"];
  EXPECT_NEAR(change.duration(), expected["T"].get<double>(), 1e-6);
  EXPECT_NEAR(change.distance(), expected["dist"].get<double>(), 1e-6);
  EXPECT_NEAR(change.peakAcceleration(), expected["a_peak"].get<double>(), 1e-6);
  EXPECT_EQ(change.hasFlat(), expected["linear"].get<bool>());
}

void straightTime(const json& row) {
  const double length = row["inputs"]["L"].get<double>();
  const auto line = *CubicSpline::uniform(
      {{0, 0, 0}, {0.3 * length, 0, 0}, {0.7 * length, 0, 0}, {length, 0, 0}}, false);
  EXPECT_NEAR(machiningTime(line, {row["inputs"]["V"].get<double>(), source::machine.acceleration,
                                   source::machine.jerk}),
              row["expected"]["t"].get<double>(), 1e-9);
}

void givenSpline(const json& row) {
  const CubicSpline curve = naseathSpline(row["inputs"]["which"].get<int>());
  const json& expected = row["expected"];
  EXPECT_NEAR(curve.length(), expected["length"].get<double>(), 1e-4);
  EXPECT_NEAR(curvatureFigures(curve, 50).mean, expected["curv_mean"].get<double>(), 1e-4);
  EXPECT_NEAR(curvatureFigures(curve, 50).most, expected["curv_max"].get<double>(), 1e-4);
  EXPECT_NEAR(source::machiningTime(curve, samples), expected["time"].get<double>(),
              0.01 * expected["time"].get<double>());
  EXPECT_EQ(curve.control().size(), expected["n_ctrl"].get<std::size_t>());
}

void smoothCase(const json& row) {
  const CubicSpline curve = naseathSpline(row["inputs"]["which"].get<int>());
  const double radius = row["inputs"]["R"].get<double>();
  const Smoothed result = bySource(curve, radius);
  const auto before = curvatureFigures(curve, 50);
  const auto after = curvatureFigures(result.curve, 50);
  const double time = source::machiningTime(result.curve, samples);
  const std::map<std::string, double> found = {
      {"length", result.curve.length()},
      {"curv_mean", after.mean},
      {"curv_max", after.most},
      {"time", time},
      {"dev", result.deviation},
      {"dev_before_guard", result.deviation},  // ours is never passed
      {"impr_curv", percent(before.mean, after.mean)},
      {"impr_time", percent(source::machiningTime(curve, samples), time)},
      {"impr_len", percent(curve.length(), result.curve.length())},
      {"iterations", static_cast<double>(result.iterations)}};
  for (const auto& [name, value] : row["expected"].items()) {
    ASSERT_TRUE(found.contains(name)) << name;
    const double allowed = row["tolerance"][name].get<double>();
    EXPECT_NEAR(found.at(name), value.get<double>(), allowed) << name;
  }
  EXPECT_LE(result.deviation, radius);
}

void trend(const json& row) {
  const CubicSpline curve = naseathSpline(row["inputs"]["which"].get<int>());
  double mean = curvatureFigures(curve, 20).mean;
  double length = curve.length();
  double time = source::machiningTime(curve, samples);
  for (const double radius : {0.025, 0.125, 0.25}) {
    const CubicSpline now = bySource(curve, radius).curve;
    EXPECT_LT(curvatureFigures(now, 20).mean, mean) << radius;
    EXPECT_LT(now.length(), length) << radius;
    EXPECT_LT(source::machiningTime(now, samples), time) << radius;
    mean = curvatureFigures(now, 20).mean;
    length = now.length();
    time = source::machiningTime(now, samples);
  }
}

/// The source's tables 4-1 to 4-4 are of its own paths, which it shows only in figures: arelem
/// computes none of their numbers. What rows say of each other is checked.
Numbers published(const char* id) {
  return naseathCase(id)["published"]["pct"].get<Numbers>();
}

void publishedPercentages(const json& row) {
  expectNear(row["published"]["pct"].get<Numbers>(), row["expected"]["pct"],
             row["published_tol"].get<double>());
}

void publishedAverages(const json& row) {
  const bool differs = row["status"] == "differs";
  for (const auto& [name, averages] : row["published"].items()) {
    const Numbers all = published(("NAS-pct-" + name).c_str());
    double farthest = 0.0;
    for (std::size_t column = 0; column < 4; ++column) {  // of all, then of each tolerance
      double sum = 0.0;
      std::size_t count = 0;
      for (std::size_t i = 0; i < all.size(); ++i) {
        if (column == 0 || i % 3 == column - 1) {
          sum += all[i];
          ++count;
        }
      }
      const double gap = sum / static_cast<double>(count) - averages[column].get<double>();
      farthest = std::max(farthest, std::abs(gap));
    }
    EXPECT_EQ(farthest > 0.011, differs) << name << ' ' << farthest;
  }
}

double correlation(const Numbers& a, const Numbers& b) {
  const auto n = static_cast<double>(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
  }
  return ab / std::sqrt(aa * bb);
}

std::string tableOf(const std::string& shortName) {
  return shortName == "len" ? "NAS-pct-length" : "NAS-pct-" + shortName;
}

void publishedCorrelations(const json& row) {
  const bool differs = row["status"] == "differs";
  for (const auto& [pair, expected] : row["published"].items()) {
    const std::size_t middle = pair.find('_');
    const double found = correlation(published(tableOf(pair.substr(0, middle)).c_str()),
                                     published(tableOf(pair.substr(middle + 1)).c_str()));
    EXPECT_EQ(std::abs(found - expected.get<double>()) > 0.001, differs) << pair << ' ' << found;
  }
}

/// One ripple of this height and half width on a straight path.
CubicSpline ripple(double height, double halfWidth) {
  std::vector<Vec3> points;
  for (int i = -12; i <= 12; ++i) {
    const double x = 0.5 * i;
    points.emplace_back(halfWidth * x, std::abs(x) < 1.0 ? height * (1.0 - std::abs(x)) : 0.0, 0.0);
  }
  return *spline::interpolate(points, false);
}

double gainOfCurvature(const CubicSpline& curve, double radius) {
  return percent(curvatureFigures(curve, 50).mean,
                 curvatureFigures(bySource(curve, radius).curve, 50).mean);
}

/// Ripples of one shape: the peak grows as they shrink, and so does the gain at one tolerance.
void similarRipples(const json& row) {
  EXPECT_TRUE(row["published"]["sharper_gains_more"].get<bool>());
  double before = 0.0;
  double peak = 0.0;
  for (const double scale : row["inputs"]["scales"].get<Numbers>()) {
    const CubicSpline curve = ripple(0.8 * scale, 2.0 * scale);
    const double now = gainOfCurvature(curve, row["inputs"]["R"].get<double>());
    EXPECT_GT(now, before) << scale;
    before = now;
    const double most = scale * curvatureFigures(curve, 50).most;
    EXPECT_NEAR(most, peak == 0.0 ? most : peak, 1e-9);
    peak = most;
  }
}

/// Ripples of one height: the narrower, the sharper; the narrowest gain far less than the widest.
void rippleFamily(const json& row) {
  Numbers gains;
  double peak = 0.0;
  for (const double width : row["inputs"]["widths"].get<Numbers>()) {
    const CubicSpline curve = ripple(row["inputs"]["h"].get<double>(), width);
    gains.push_back(gainOfCurvature(curve, row["inputs"]["R"].get<double>()));
    EXPECT_GT(curvatureFigures(curve, 50).most, peak) << width;
    peak = curvatureFigures(curve, 50).most;
  }
  const json& rows = row["expected"]["rows"];
  EXPECT_NEAR(gains.back() / gains.front(),
              rows.back()[2].get<double>() / rows.front()[2].get<double>(), 0.5);
  EXPECT_LT(gains.back(), gains.front());
}

/// The source's "per cent of the ideal time", one of which is printed wrong.
void percentOfIdeal(const json& row) {
  const double share =
      100.0 * row["inputs"]["t"].get<double>() / row["inputs"]["ideal"].get<double>();
  EXPECT_NEAR(share, row["expected"]["pct"].get<double>(), 1e-9);
  EXPECT_EQ(std::abs(share - row["published"]["pct"].get<double>()) > 0.6,
            row["status"] == "differs");
}

/// The source shows these paths only in figures; its results for them cannot be computed.
void notReproducible(const json& row) {
  EXPECT_EQ(row["status"], "not reproducible");
  EXPECT_NE(row["note"].get<std::string>().find("in figures"), std::string::npos);
}

TEST(Naseath, EveryRowIsChecked) {
  const std::map<std::string, std::function<void(const json&)>> checks = {
      {"kmax", speedLimits},
      {"vmax_at", speedLimits},
      {"sensitivity", sensitivity},
      {"bern", bernstein},
      {"curv36", startCurvature},
      {"offset", offset},
      {"prm", actingPlaces},
      {"to_bezier", toBezier},
      {"cats", polygonCategories},
      {"dirs", polygonDirections},
      {"scurve_case", changeOfSpeed},
      {"straight_time", straightTime},
      {"spline_of", givenSpline},
      {"smooth_case", smoothCase},
      {"trend", trend},
      {"table_pct", publishedPercentages},
      {"averages", publishedAverages},
      {"pearson", publishedCorrelations},
      {"scaled_family", similarRipples},
      {"ripple_family", rippleFamily},
      {"pct_of_ideal", percentOfIdeal},
      {"", notReproducible}};
  std::ifstream file(ARELEM_SOURCE_DIR "/tests/data/golden/cases_naseath.json");
  const json rows = json::parse(file);
  EXPECT_EQ(rows.size(), 51U);
  for (const json& row : rows) {
    SCOPED_TRACE(row["id"].get<std::string>());
    const std::string name = row.value("fn", "");
    const auto check = checks.find(name.substr(name.find('.') + 1));
    if (check == checks.end()) {
      ADD_FAILURE() << "no check for " << name;
      continue;
    }
    check->second(row);
  }
}

}  // namespace
}  // namespace arelem::smooth
