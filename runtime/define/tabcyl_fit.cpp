#include "runtime/define/tabcyl_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"
#include "runtime/define/tangent_solver.h"

namespace arelem::define {

using geometry::TabulatedCylinder;
using geometry::Vec2;

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr int largestTurn = 175;
/// The straight intervals are this many times as long as all chords together.
constexpr double extensionFactor = 10.0;

using Interval = TabulatedCylinder::Interval;

double angleOf(const Vec2& v) {
  return std::atan2(v.y(), v.x());
}

/// The angle equal to `angle` modulo `period` that is nearest to `reference`.
double nearestTo(double reference, double angle, double period) {
  return angle + period * std::round((reference - angle) / period);
}

/// Chords with continuous angles. Fails on coincident neighbors and where the curve turns back.
Result<std::vector<Chord>> chordsOf(const std::vector<CurveNode>& nodes) {
  std::vector<Chord> chords;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Vec2 step = nodes[i + 1].place - nodes[i].place;
    const double length = step.norm();
    if (!(length > tolerance::coincidence)) {
      return fail(diag::Coincident, fmt::format("points {} and {} of the curve", i + 1, i + 2),
                  length);
    }
    double angle = angleOf(step);
    if (i > 0) {
      angle = nearestTo(chords.back().angle, angle, 2.0 * std::numbers::pi);
      const double turn = (angle - chords.back().angle) / degree;
      if (std::abs(turn) >= largestTurn) {
        return fail(diag::CurveTurnsBack, i + 1, turn, largestTurn);
      }
    }
    chords.push_back({length, angle});
  }
  return chords;
}

/// Estimated tangents: inside, of the circle through three neighbors (tangent and chord make the
/// inscribed angle); at the ends, the neighbor's mirrored in the chord. Given tangents replace
/// them, in the nearer sense.
std::vector<double> firstTangents(const std::vector<CurveNode>& nodes,
                                  const std::vector<Chord>& chords) {
  const std::size_t n = nodes.size();
  std::vector<double> angles(n);
  const auto replaceByGiven = [&](std::size_t i) {
    if (nodes[i].tangent) {
      angles[i] = nearestTo(angles[i], angleOf(*nodes[i].tangent), std::numbers::pi);
    }
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = chords[i - 1].angle;
    const double behind = chords[i].angle;
    const double across =
        nearestTo(0.5 * (before + behind), angleOf(nodes[i + 1].place - nodes[i - 1].place),
                  2.0 * std::numbers::pi);
    angles[i] = before + behind - across;
    replaceByGiven(i);
  }
  angles[0] = 2.0 * chords.front().angle - angles[1];
  replaceByGiven(0);
  angles[n - 1] = 2.0 * chords.back().angle - angles[n - 2];
  replaceByGiven(n - 1);
  return angles;
}

Interval intervalOn(const CurveNode& from, const CurveNode& to) {
  Interval interval;
  interval.start = from.place;
  interval.length = (to.place - from.place).norm();
  interval.along = (to.place - from.place) / interval.length;
  return interval;
}

/// Cubics from tangent angles.
Result<std::vector<Interval>> fromTangents(const std::vector<CurveNode>& nodes,
                                           const std::vector<Chord>& chords,
                                           const std::vector<double>& angles) {
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    for (const std::size_t end : {i, i + 1}) {
      const double off = (angles[end] - chords[i].angle) / degree;
      if (!(std::abs(off) < largestTangentAngle)) {
        return fail(diag::TangentAcrossChord, end + 1, off, end == i ? i + 2 : i + 1,
                    largestTangentAngle);
      }
    }
    Interval interval = intervalOn(nodes[i], nodes[i + 1]);
    const double s = std::tan(angles[i] - chords[i].angle);
    const double e = std::tan(angles[i + 1] - chords[i].angle);
    interval.a = (s + e) / (interval.length * interval.length);
    interval.b = -(2.0 * s + e) / interval.length;
    intervals.push_back(interval);
  }
  return intervals;
}

/// v = t (t - L)(a t + e) takes the offset of another node at t: a t + e = v/(t (t - L)).
struct Other {
  double t = 0.0, quotient = 0.0;
};
Result<Other> otherNode(const std::vector<CurveNode>& nodes,
                        std::size_t chord,
                        std::size_t other,
                        const Interval& interval) {
  const Vec2 local = nodes[other].place - interval.start;
  const double t = local.dot(interval.along);
  const double product = t * (t - interval.length);
  if (!(std::abs(product) > tolerance::coincidence * interval.length)) {
    return fail(diag::FoldedCubic, chord + 1, chord + 2, other + 1,
                std::min(std::abs(t), std::abs(t - interval.length)));
  }
  return Other{t, local.dot(interval.across()) / product};
}

/// Each cubic through its chord's ends and the two nodes around; at the ends of the curve the next
/// two, and of three nodes the parabola through all of them.
Result<std::vector<Interval>> throughFour(const std::vector<CurveNode>& nodes) {
  const std::size_t n = nodes.size();
  std::vector<Interval> intervals;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    Interval interval = intervalOn(nodes[i], nodes[i + 1]);
    const std::size_t firstNode = std::min(i > 0 ? i - 1 : 0, n >= 4 ? n - 4 : 0);
    std::vector<Other> others;
    for (std::size_t k = firstNode; k < std::min(firstNode + 4, n); ++k) {
      if (k == i || k == i + 1) {
        continue;
      }
      Result<Other> other = otherNode(nodes, i, k, interval);
      if (!other) {
        return other.takeFailure();
      }
      others.push_back(*other);
    }
    double e = others[0].quotient;
    if (others.size() == 2) {
      const double apart = others[1].t - others[0].t;
      if (!(std::abs(apart) > tolerance::coincidence)) {
        return fail(diag::FoldedCubic, i + 1, i + 2, firstNode + 4, apart);
      }
      interval.a = (others[1].quotient - others[0].quotient) / apart;
      e = others[0].quotient - interval.a * others[0].t;
    }
    interval.b = e - interval.a * interval.length;
    intervals.push_back(interval);
  }
  return intervals;
}

/// Adds the straight intervals along the end tangents and the bounds.
TabulatedCylinder extended(std::vector<Interval> intervals, const Vec2& last) {
  double total = 0.0;
  for (Interval& interval : intervals) {
    interval.bound();
    total += interval.length;
  }
  const double length = extensionFactor * total;
  Interval before;
  before.along = intervals.front().at(0.0).tangent.normalized();
  before.length = length;
  before.start = intervals.front().start - length * before.along;
  before.extension = true;
  Interval behind;
  behind.along = intervals.back().at(intervals.back().length).tangent.normalized();
  behind.length = length;
  behind.start = last;
  behind.extension = true;
  TabulatedCylinder result;
  result.end = last + length * behind.along;
  result.intervals.push_back(before);
  result.intervals.insert(result.intervals.end(), intervals.begin(), intervals.end());
  result.intervals.push_back(behind);
  return result;
}

/// Guesses for sharp turns, where the tangent of the circle is far from the wanted one: between
/// both chords.
std::vector<double> betweenChords(const std::vector<CurveNode>& nodes,
                                  const std::vector<Chord>& chords,
                                  std::vector<double> angles) {
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    if (!nodes[i].tangent) {
      angles[i] = 0.5 * (chords[i - 1].angle + chords[i].angle);
    }
  }
  if (!nodes.front().tangent) {
    angles.front() = 2.0 * chords.front().angle - angles[1];
  }
  if (!nodes.back().tangent) {
    angles.back() = 2.0 * chords.back().angle - angles[nodes.size() - 2];
  }
  return angles;
}

Result<std::vector<double>> splineTangents(const std::vector<CurveNode>& nodes,
                                           const std::vector<Chord>& chords,
                                           const std::vector<double>& circles,
                                           std::optional<Failure>& remark) {
  std::vector<bool> fixed;
  for (const CurveNode& node : nodes) {
    fixed.push_back(node.tangent.has_value());
  }
  const std::vector<double> between = betweenChords(nodes, chords, circles);
  for (const std::vector<double>* guess : {&circles, &between}) {
    Result<std::optional<std::vector<double>>> solved = solveTangents(chords, fixed, *guess);
    if (!solved && guess == &between) {
      return solved.takeFailure();
    }
    if (solved && *solved) {
      return **std::move(solved);
    }
  }
  RelaxedTangents relaxed = relaxTangents(chords, fixed, between);
  if (relaxed.jump > 0.0) {
    remark = fail(diag::CurvatureJumps, relaxed.jump, relaxed.worst + 1)
                 .withHelp("give more points where the curve turns sharply, or slopes with TWOPT");
  }
  return std::move(relaxed.angles);
}

Result<std::vector<Interval>> cubics(const std::vector<CurveNode>& nodes,
                                     FitMethod method,
                                     std::optional<Failure>& remark) {
  Result<std::vector<Chord>> chords = chordsOf(nodes);
  if (!chords) {
    return chords.takeFailure();
  }
  if (method == FitMethod::fourPoint) {
    return throughFour(nodes);
  }
  std::vector<double> angles = firstTangents(nodes, *chords);
  if (method == FitMethod::spline) {
    Result<std::vector<double>> solved = splineTangents(nodes, *chords, angles, remark);
    if (!solved) {
      return solved.takeFailure();
    }
    angles = *std::move(solved);
  }
  return fromTangents(nodes, *chords, angles);
}

}  // namespace

Result<TabulatedCylinder> fitCurve(const std::vector<CurveNode>& nodes,
                                   FitMethod method,
                                   std::optional<Failure>& remark) {
  constexpr std::size_t fewest = 3;
  if (nodes.size() < fewest) {
    return fail(diag::TooFewPoints, nodes.size(), "TABCYL", static_cast<int>(fewest));
  }
  Result<std::vector<Interval>> intervals = cubics(nodes, method, remark);
  if (!intervals) {
    return intervals.takeFailure();
  }
  return extended(*std::move(intervals), nodes.back().place);
}

}  // namespace arelem::define
