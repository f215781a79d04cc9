#pragma once
#include "ir/diag/result.h"
#include "ir/limits.h"
#include "runtime/spline/cubic.h"
#include "runtime/timing/transition.h"

/// SMOOTH: paths of less curvature inside a tube round the given one.
namespace arelem::smooth {

enum class Method : std::uint8_t {
  source,  ///< the algorithm of Naseath, chapter 3
  tube,    ///< least curvature inside the tube by convex problems: the largest one falls most
  time     ///< such paths of more and more control points where the curvature limits the speed:
           ///< the one that takes the least time
};

struct Options {
  double tolerance = 0.0;  ///< radius of the tube, part unit
  Method method = Method::tube;
  int precision = 5;  ///< source: samples of each knot interval in the search for the deviation
  double accuracy =
      0.01;  ///< source: ends when so little of the tolerance is left, as a share of it
  /// source: bound on the work.
  int mostIterations = 200;
  bool fixedEnds = true;  ///< tube, time: the ends of an open curve stay. The source moves them.
  /// time: of the machine, in the part unit; its velocity may be the feed.
  timing::Limits limits{400.0, 4000.0, 20000.0};
  const InterruptFlag* interrupted = nullptr;
};

struct Smoothed {
  spline::CubicSpline curve;
  double deviation = 0.0;  ///< from the given curve, an upper bound: at most the tolerance
  int iterations = 0;
};

/// The control points move; the knots stay, and `tube` adds one in the middle of each interval
/// first, `time` up to three times where the curve is too sharp for the feed. Linear in the number
/// of control points: long paths are solved in windows. Every point of the new curve is within the
/// tolerance of the point of the given curve at the same parameter, certified by the Bezier points
/// of the difference. Errors: a tolerance or accuracy that is not positive, precision below 1.
[[nodiscard]] Result<Smoothed> smooth(const spline::CubicSpline& curve, const Options& options);

/// Moves the control points back towards those of `original`, all by one factor, until the
/// certified deviation is at most `tolerance`.
[[nodiscard]] Smoothed guarded(const spline::CubicSpline& original,
                               const spline::CubicSpline& moved,
                               double tolerance);

[[nodiscard]] Smoothed sourceMethod(const spline::CubicSpline& curve, const Options& options);
[[nodiscard]] Smoothed tubeMethod(const spline::CubicSpline& curve, const Options& options);
[[nodiscard]] Smoothed timeMethod(const spline::CubicSpline& curve, const Options& options);

/// Time of a machine along a curve that it enters and leaves at the speed that the curve allows; a
/// long path in parts that are each timed so.
[[nodiscard]] double machiningTime(const spline::CubicSpline& curve, const timing::Limits& limits);

}  // namespace arelem::smooth
