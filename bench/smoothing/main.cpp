// Measures SMOOTH and the time law: the methods against each other on the source's noisy line and
// square, the growth of the computing time, and the moves that the time law takes a second. Prints
// tables in Markdown. docs/manual/smoothing.md says what they mean.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "bench/smoothing/source_inputs.h"
#include "bench/smoothing/source_time.h"
#include <fmt/format.h>
#include <sys/resource.h>

#include "runtime/smooth/smooth.h"
#include "runtime/spline/fit.h"
#include "runtime/timing/cut_timer.h"
#include "runtime/timing/spline_limits.h"

namespace {

using namespace arelem;
namespace source = smooth::source;
using spline::CubicSpline;

constexpr timing::Limits machine{400.0, 4000.0, 20000.0};
constexpr int repeats = 9;

/// Median of some runs, in seconds of one processor.
double seconds(const std::function<void()>& work, int runs = repeats) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const std::clock_t start = std::clock();
    work();
    times.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<std::size_t>(runs / 2)];
}

/// Naseath's test cases 5 and 6 with other distances between the points than source_inputs.h has,
/// at chord lengths: gentler ones.
CubicSpline gentleLine() {
  std::vector<Vec3> points;
  for (int i = 0; i < 28; ++i) {
    const double x = 100.0 / 27.0 * i;
    points.emplace_back(x, 0.0, 0.0);
    if (i == 9 || i == 18) {
      points.emplace_back(x + 0.37, 0.2, 0.0);
    }
  }
  return *spline::interpolate(points, false);
}
CubicSpline gentleSquare() {
  std::vector<Vec3> points{Vec3::Zero()};
  for (int leg = 0; leg < 5; ++leg) {
    const bool up = leg == 1;
    const bool down = leg == 3;
    for (int i = 0; i < 5; ++i) {
      points.push_back(points.back() + 4.8 * (up     ? Vec3(0, 1, 0)
                                              : down ? Vec3(0, -1, 0)
                                                     : Vec3(1, 0, 0)));
    }
  }
  return *spline::interpolate(points, false);
}

std::vector<source::PublishedCase> cases() {
  std::vector<source::PublishedCase> all = source::publishedCases();
  const auto& line = all[0];
  const auto& square = all[1];
  all.push_back({"gentler line", gentleLine(), 0, 0.0, 0.0, line.gains, line.corners});
  all.push_back(
      {"gentler square", gentleSquare(), 0, 0.0, 0.0, square.gains, source::corners(24.0)});
  return all;
}

double machiningTime(const CubicSpline& curve) {
  timing::SpeedLimits path;
  path.freeEnds = true;
  timing::appendCurve(path, curve, 50, machine.velocity, machine.acceleration);
  path.corners.push_back(machine.velocity);
  return timing::Plan(std::move(path), machine).duration();
}

double sourceTime(const CubicSpline& curve) {
  return source::machiningTime(curve, 50);
}

smooth::Options optionsOf(double radius, smooth::Method method) {
  smooth::Options options;
  options.tolerance = radius;
  options.method = method;
  options.limits = machine;
  return options;
}

void compare(const source::PublishedCase& one) {
  const CubicSpline& curve = one.curve;
  const auto before = curvatureFigures(curve, 50);
  const double time = machiningTime(curve);
  const double his = sourceTime(curve);
  fmt::print("| {} | | before | {:.4f} | {:.4f} | {:.3f} | {:.4f} | | {:.3f} | | |\n", one.name,
             before.most, before.mean, curve.length(), time, his);
  for (const source::PublishedGain& row : one.gains) {
    fmt::print("| | {} | source, published | | | | | | | {:.1f} % | {:.0f} ms |\n", row.radius,
               100.0 * row.time, row.computing * 1e3);
    for (const smooth::Method method :
         {smooth::Method::source, smooth::Method::tube, smooth::Method::time}) {
      const smooth::Options options = optionsOf(row.radius, method);
      const auto result = smooth::smooth(curve, options);
      const double spent = seconds([&] { static_cast<void>(smooth::smooth(curve, options)); });
      const auto after = curvatureFigures(result->curve, 50);
      const double now = machiningTime(result->curve);
      const double hisNow = sourceTime(result->curve);
      fmt::print(
          "| | {} | METHOD, {} | {:.4f} | {:.4f} | {:.3f} | {:.4f} | {:.1f} % | {:.3f} | {:.1f} % "
          "| "
          "{:.2f} ms |\n",
          row.radius, static_cast<int>(method) + 1, after.most, after.mean, result->curve.length(),
          now, 100.0 * (1.0 - now / time), hisNow, 100.0 * (1.0 - hisNow / his), spent * 1e3);
    }
  }
}

/// METHOD 3 by the time law of the source, against what he publishes and what no path can pass.
void goal(const source::PublishedCase& one) {
  const double before = sourceTime(one.curve);
  for (const source::PublishedGain& row : one.gains) {
    const auto least = smooth::smooth(one.curve, optionsOf(row.radius, smooth::Method::time));
    const double gain = 1.0 - sourceTime(least->curve) / before;
    const double most = 1.0 - source::leastTime(one.corners, row.radius) / before;
    fmt::print("| {} | {} | {:.1f} % | {:.1f} % | {:.1f} | {:.1f} % | {:.0f} % |\n", one.name,
               row.radius, 100.0 * row.time, 100.0 * gain, gain / row.time, 100.0 * most,
               100.0 * gain / most);
  }
}

void compareMethods() {
  const std::vector<source::PublishedCase> all = cases();
  fmt::print(
      "| case | tolerance | method | largest curvature | mean | length | time, s | less time | by "
      "his "
      "law, s | less time | computing |\n|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const source::PublishedCase& one : all) {
    compare(one);
  }
  fmt::print(
      "\n| by his law | tolerance | published | METHOD, 3 | times | at most | of that |\n"
      "|---|---|--:|--:|--:|--:|--:|\n");
  for (const source::PublishedCase& one : all) {
    goal(one);
  }
}

/// A wavy path in space of so many control points.
CubicSpline wave(std::size_t points) {
  std::vector<Vec3> control;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = 0.5 * static_cast<double>(i);
    control.emplace_back(x, std::sin(0.3 * x) + (i * 7919 % 101) * 1e-3, 0.2 * std::cos(0.11 * x));
  }
  return *CubicSpline::uniform(std::move(control), false);
}

/// Largest resident memory so far, MB.
long memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

/// The memory is that of the process, input and output with it; a method's needs are more than
/// those of the one before.
void growthOfSmoothing() {
  fmt::print("\n| control points |");
  for (int method = 1; method <= 3; ++method) {
    fmt::print(" METHOD, {} | a second | MB |", method);
  }
  fmt::print("\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const std::size_t count : {1'000, 10'000, 100'000, 1'000'000}) {
    const CubicSpline curve = wave(count);
    std::string row = fmt::format("| {} |", count);
    for (const smooth::Method method :
         {smooth::Method::source, smooth::Method::tube, smooth::Method::time}) {
      const smooth::Options options = optionsOf(0.05, method);
      const double spent = seconds([&] { static_cast<void>(smooth::smooth(curve, options)); }, 1);
      row += fmt::format(" {:.3f} s | {:.0f} | {} |", spent, static_cast<double>(count) / spent,
                         memory());
    }
    fmt::print("{}\n", row);
  }
}

void growthOfTheTimeLaw() {
  fmt::print("\n| moves | seconds | a second |\n|--:|--:|--:|\n");
  for (const std::size_t count : {1'000, 10'000, 100'000, 1'000'000}) {
    std::vector<cl::Record> records;
    cl::Record feed;
    feed.body = cl::Post{Word::FEDRAT, "", {6000.0}};
    records.push_back(feed);
    const CubicSpline curve = wave(1000);
    for (std::size_t i = 0; i < count; ++i) {
      const double t = curve.end() * static_cast<double>(i % 10000) / 10000.0;
      const Vec3 p = curve.at(t) + Vec3(0, static_cast<double>(i / 10000) * 5.0, 0);
      cl::Record record;
      cl::Motion motion;
      motion.kind = i == 0 ? cl::Motion::Kind::from : cl::Motion::Kind::go;
      motion.coordinates = {p.x(), p.y(), p.z()};
      record.body = motion;
      records.push_back(std::move(record));
    }
    const double spent = seconds(
        [&] {
          CollectingSink sink;
          timing::CutTimer timer({machine, 0.01, 10.0}, sink);
          for (const cl::Record& record : records) {
            timer.accept(record);
          }
          static_cast<void>(timer.finish());
        },
        3);
    fmt::print("| {} | {:.4f} | {:.0f} |\n", count, spent, static_cast<double>(count) / spent);
  }
}

}  // namespace

/// With an argument, the table of the methods alone: a test compares the manual with it.
int main(int count, char** /*words*/) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  compareMethods();
  if (count > 1) {
    return 0;
  }
  growthOfSmoothing();
  growthOfTheTimeLaw();
}
