// The time law: the source's transitions, and profiles checked by differences of their places.
#include <cmath>
#include <ctime>
#include <random>

#include <gtest/gtest.h>

#include "runtime/smooth/smooth.h"
#include "runtime/timing/spline_limits.h"
#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::timing {
namespace {

using spline::naseathCase;
constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(Transition, CasesOfTheSource) {
  for (const char* id : {"NAS-scurve-0-400-4000", "NAS-scurve-63.25-400-4000",
                         "NAS-scurve-0-400-2000", "NAS-scurve-400-100-4000"}) {
    const auto one = naseathCase(id);
    const auto& in = one["inputs"];
    const auto& expected = one["expected"];
    const Transition change(in["v0"].get<double>(), in["v1"].get<double>(),
                            {400.0, in["A"].get<double>(), in["J"].get<double>()});
    EXPECT_NEAR(change.duration(), expected["T"].get<double>(), 1e-6) << id;
    EXPECT_NEAR(change.distance(), expected["dist"].get<double>(), 1e-6) << id;
    EXPECT_NEAR(change.peakAcceleration(), expected["a_peak"].get<double>(), 1e-6) << id;
    EXPECT_EQ(change.hasFlat(), expected["linear"].get<bool>()) << id;
  }
}

TEST(Transition, SpeedLimitsOfTheSource) {
  EXPECT_NEAR(curveSpeed(0.025, 4000.0), 400.0, 1e-9);
  EXPECT_NEAR(curveSpeed(1.0, 4000.0), 63.245553203367585, 1e-9);
}

TEST(Transition, TimeAndPlaceBelongTogether) {
  for (const auto& [from, to] : {std::pair{0.0, 300.0}, {300.0, 20.0}, {50.0, 60.0}}) {
    const Transition change(from, to, {400.0, 1000.0, 20000.0});
    for (int i = 0; i <= 50; ++i) {
      const double t = change.duration() * i / 50.0;
      EXPECT_NEAR(change.timeAt(change.at(t).place), t, 1e-7 * change.duration() + 1e-7);
      EXPECT_NEAR(change.placeOf(change.at(t).speed), change.at(t).place, 1e-6);
    }
  }
}

/// Speed, acceleration and jerk from the places alone, against the limits.
void checkByDifferences(const Plan& plan, const SpeedLimits& path, const Limits& limits) {
  std::vector<double> places{0.0};
  for (const double length : path.lengths) {
    places.push_back(places.back() + length);
  }
  const int samples = 40000;
  const double h = plan.duration() / samples;
  std::vector<double> s(samples + 1);
  for (int i = 0; i <= samples; ++i) {
    s[static_cast<std::size_t>(i)] = plan.at(std::min(i * h, plan.duration())).place;
  }
  double worstSpeed = 0.0, worstAcceleration = 0.0, worstJerk = 0.0;
  for (std::size_t i = 3; i < s.size(); ++i) {
    const double speed = (s[i] - s[i - 1]) / h;
    const double middle = 0.5 * (s[i] + s[i - 1]);
    const auto next = std::upper_bound(places.begin(), places.end(), middle);
    const auto k = std::clamp<std::size_t>(static_cast<std::size_t>(next - places.begin()), 1,
                                           path.speeds.size()) -
                   1;
    // A sample may reach over into a neighbor.
    double limit = path.speeds[k];
    if (s[i] > places[k + 1] && k + 1 < path.speeds.size()) {
      limit = std::max(limit, path.speeds[k + 1]);
    }
    if (s[i - 1] < places[k] && k > 0) {
      limit = std::max(limit, path.speeds[k - 1]);
    }
    worstSpeed = std::max(worstSpeed, speed / limit);
    worstAcceleration =
        std::max(worstAcceleration, std::abs(s[i] - 2.0 * s[i - 1] + s[i - 2]) / (h * h));
    worstJerk = std::max(worstJerk,
                         std::abs(s[i] - 3.0 * s[i - 1] + 3.0 * s[i - 2] - s[i - 3]) / (h * h * h));
  }
  EXPECT_LE(worstSpeed, 1.0 + 1e-6);
  EXPECT_LE(worstAcceleration, limits.acceleration * 1.001);
  EXPECT_LE(worstJerk, limits.jerk * 1.02);
}

TEST(Plan, RandomPathsKeepAllLimits) {
  const Limits limits{400.0, 3000.0, 20000.0};
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> length(0.2, seed % 3 == 0 ? 60.0 : 4.0);
    std::uniform_real_distribution<double> share(0.05, 1.0);
    SpeedLimits path;
    for (int i = 0; i < 60; ++i) {
      path.lengths.push_back(length(random));
      path.speeds.push_back(limits.velocity * share(random));
      path.corners.push_back(share(random) < 0.3 ? limits.velocity * share(random) : infinite);
    }
    path.corners.front() = 0.0;
    path.corners.push_back(0.0);
    const Plan plan(path, limits);
    checkByDifferences(plan, path, limits);
    double sum = 0.0;
    for (const double time : plan.pieceTimes()) {
      EXPECT_GE(time, 0.0);
      sum += time;
    }
    EXPECT_NEAR(sum, plan.duration(), 1e-9);
    EXPECT_NEAR(plan.at(plan.duration()).place, plan.length(), 1e-6);
  }
}

TEST(Plan, OneStraightMoveByPencil) {
  // From rest to rest over 56.5685 * 2 + 100 mm: two changes of 0.2828427 s and 0.25 s at 400 mm/s.
  SpeedLimits path{{2.0 * 56.568542494923804 + 100.0}, {400.0}, {0.0, 0.0}, false};
  const Plan plan(path, {400.0, 4000.0, 20000.0});
  EXPECT_NEAR(plan.duration(), 2.0 * 0.282842712474619 + 0.25, 1e-9);
}

TEST(Plan, CollinearPiecesTakeTheTimeOfOne) {
  const Limits limits{400.0, 4000.0, 20000.0};
  SpeedLimits one{{120.0}, {300.0}, {0.0, 0.0}, false};
  SpeedLimits many{std::vector<double>(1200, 0.1), std::vector<double>(1200, 300.0),
                   std::vector<double>(1201, infinite), false};
  many.corners.front() = many.corners.back() = 0.0;
  EXPECT_NEAR(Plan(one, limits).duration(), Plan(many, limits).duration(), 1e-9);
}

TEST(Plan, FreeEndsAreTheSourcesIdealTime) {
  const auto one = naseathCase("NAS-ideal");
  SpeedLimits path{{one["inputs"]["L"].get<double>()},
                   {one["inputs"]["V"].get<double>()},
                   {infinite, infinite},
                   true};
  EXPECT_NEAR(Plan(path, {400.0, 4000.0, 20000.0}).duration(), one["expected"]["t"].get<double>(),
              1e-9);
}

TEST(Plan, CornersByPencil) {
  EXPECT_EQ(cornerSpeed(1.0, 0.01, 4000.0, 10.0), infinite);
  EXPECT_EQ(cornerSpeed(-1.0, 0.01, 4000.0, 10.0), 0.0);
  // A right angle: r = 0.01 * cos 45 / (1 - cos 45) = 0.0241421, v = sqrt(4000 r).
  EXPECT_NEAR(cornerSpeed(0.0, 0.01, 4000.0, 10.0), std::sqrt(4000.0 * 0.024142135623731), 1e-6);
  // Legs of 0.02: the circle touches them 0.01 from the corner, r = 0.01.
  EXPECT_NEAR(cornerSpeed(0.0, 0.01, 4000.0, 0.02), std::sqrt(40.0), 1e-9);
}

/// Chords of a circle are passed as fast as the circle, however short they are.
TEST(Plan, CornersOfChordsAreThoseOfTheCircle) {
  for (const double angle : {0.2, 0.01, 1e-4}) {
    const double radius = 2.0;
    const double chord = 2.0 * radius * std::sin(0.5 * angle);
    EXPECT_NEAR(cornerSpeed(std::cos(angle), 10.0, 4000.0, chord), std::sqrt(4000.0 * radius),
                angle * angle * 100.0);
  }
}

/// A speed limit that falls and rises again takes no longer when it is described by more pieces:
/// where its lowest place is between two nodes of unequal speed a node was refused once, and the
/// whole way to the next one went as slowly.
TEST(Plan, MorePiecesTakeNoLonger) {
  const auto curve = smooth::smooth(spline::naseathSpline(6),
                                    {.tolerance = 0.125, .method = smooth::Method::time});
  double before = infinite;
  for (const int perSpan : {3, 6, 12, 25, 50, 100}) {
    SpeedLimits path;
    path.freeEnds = true;
    appendCurve(path, curve->curve, perSpan, 400.0, 4000.0);
    path.corners.push_back(400.0);
    const double now = Plan(std::move(path), {400.0, 4000.0, 20000.0}).duration();
    EXPECT_LT(now, 1.002 * before) << perSpan;
    before = now;
  }
}

TEST(Plan, AMillionMoves) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> length(0.05, 0.5);
  std::uniform_real_distribution<double> share(0.02, 1.0);
  SpeedLimits path;
  for (int i = 0; i < 1'000'000; ++i) {
    path.lengths.push_back(length(random));
    path.speeds.push_back(400.0);
    path.corners.push_back(400.0 * share(random));
  }
  path.corners.front() = 0.0;
  path.corners.push_back(0.0);
  const auto start = std::clock();
  const Plan plan(std::move(path), {400.0, 4000.0, 20000.0});
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_LT(seconds, 4.0);
  EXPECT_GT(plan.duration(), plan.length() / 400.0);
}

}  // namespace
}  // namespace arelem::timing
