// What the methods gain on the source's cases, and his trends.
#include "bench/smoothing/source_inputs.h"
#include "bench/smoothing/source_time.h"
#include <gtest/gtest.h>

#include "runtime/smooth/smooth.h"
#include "tests/unit/runtime/spline/naseath_cases.h"

namespace arelem::smooth {
namespace {

using spline::CubicSpline;
using spline::naseathSpline;

const timing::Limits machine{400.0, 4000.0, 20000.0};

Smoothed smoothed(const CubicSpline& curve, double radius, Method method) {
  Options options;
  options.tolerance = radius;
  options.method = method;
  options.limits = machine;
  return *smooth(curve, options);
}

/// Share of the machining time that is saved.
double gain(const CubicSpline& curve, const CubicSpline& now) {
  return 1.0 - machiningTime(now, machine) / machiningTime(curve, machine);
}

/// More tolerance, less curvature, length and time: the trend of the source's table 4-6.
TEST(SmoothGain, TrendOfTheSource) {
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    double mean = curvatureFigures(curve, 20).mean;
    double length = curve.length();
    double time = machiningTime(curve, machine);
    for (const double radius : {0.025, 0.125, 0.25}) {
      const CubicSpline now = smoothed(curve, radius, Method::source).curve;
      EXPECT_LT(curvatureFigures(now, 20).mean, mean) << which << ' ' << radius;
      EXPECT_LT(now.length(), length) << which << ' ' << radius;
      EXPECT_LT(machiningTime(now, machine), time) << which << ' ' << radius;
      mean = curvatureFigures(now, 20).mean;
      length = now.length();
      time = machiningTime(now, machine);
    }
  }
}

/// The goal: at least twice the time that the source's algorithm saves, at the same tolerance.
TEST(SmoothGain, TwiceTheTimeOfTheSource) {
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    for (const double radius : {0.025, 0.125, 0.25}) {
      const double source = gain(curve, smoothed(curve, radius, Method::source).curve);
      const Smoothed best = smoothed(curve, radius, Method::time);
      EXPECT_GT(source, 0.0);
      EXPECT_GE(gain(curve, best.curve), 2.0 * source) << which << ' ' << radius;
      EXPECT_LE(best.deviation, radius);
    }
  }
}

/// The same by the time law of the source. On the noisy line at 0.25 mm it would take less than
/// the straight line takes.
TEST(SmoothGain, TwiceTheTimeOfTheSourceByItsOwnLaw) {
  constexpr int samples = 50;
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    const double before = source::machiningTime(curve, samples);
    for (const double radius : {0.025, 0.125, 0.25}) {
      const double saved =
          before - source::machiningTime(smoothed(curve, radius, Method::source).curve, samples);
      const double now =
          before - source::machiningTime(smoothed(curve, radius, Method::time).curve, samples);
      const double most = before - curve.length() / machine.velocity;
      EXPECT_GE(now, std::min(2.0 * saved, 0.85 * most)) << which << ' ' << radius;
      EXPECT_EQ(2.0 * saved > most, which == 5 && radius == 0.25);
    }
  }
}

/// Against the percentages that he publishes, by his time law and his machine, on inputs of his
/// control points, length and time: at least twice, or nearly the straight line at full speed.
TEST(SmoothGain, TwiceThePublishedTime) {
  constexpr int samples = 50;
  for (const source::PublishedCase& one : source::publishedCases()) {
    const double before = source::machiningTime(one.curve, samples);
    EXPECT_EQ(one.curve.control().size(), one.controlPoints) << one.name;
    EXPECT_NEAR(one.curve.length(), one.length, 0.005) << one.name;
    EXPECT_NEAR(before, one.time, 0.005) << one.name;
    for (const source::PublishedGain& row : one.gains) {
      const CubicSpline now = smoothed(one.curve, row.radius, Method::time).curve;
      const double gain = 1.0 - source::machiningTime(now, samples) / before;
      const double most = 1.0 - source::leastTime(one.corners, row.radius) / before;
      EXPECT_GE(gain, std::min(2.0 * row.time, 0.95 * most)) << one.name << ' ' << row.radius;
    }
  }
}

TEST(SmoothGain, LeastTimeIsNoWorseThanLeastCurvature) {
  for (const int which : {5, 6}) {
    const CubicSpline curve = naseathSpline(which);
    const double tube = gain(curve, smoothed(curve, 0.125, Method::tube).curve);
    EXPECT_GE(gain(curve, smoothed(curve, 0.125, Method::time).curve), tube - 0.01);
  }
}

/// A straight line of 100 mm at 400 mm/s: 0.25 s.
TEST(SmoothGain, IdealTime) {
  const auto line = *CubicSpline::uniform({{0, 0, 0}, {30, 0, 0}, {70, 0, 0}, {100, 0, 0}}, false);
  EXPECT_NEAR(machiningTime(line, machine), 0.25, 1e-9);
}

}  // namespace
}  // namespace arelem::smooth
