#include "runtime/smooth/smooth.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/spline.h"
#include "ir/space/smooth_tolerance.h"
#include "runtime/timing/plan.h"
#include "runtime/timing/spline_limits.h"

namespace arelem::smooth {

namespace {
/// Halvings of each knot interval when the deviation is certified.
constexpr int certificateHalvings = 2;
/// Pieces of each knot interval in the time law.
constexpr int samplesOfASpan = 4;
/// A long path is timed in parts of so many knot intervals: its plan would take a kilobyte for
/// each.
constexpr std::size_t timedSpans = 4096;
}  // namespace

Smoothed guarded(const spline::CubicSpline& original,
                 const spline::CubicSpline& moved,
                 double tolerance) {
  const double bound = deviationBound(original, moved, certificateHalvings);
  if (bound <= tolerance) {
    return {moved, bound, 0};
  }
  const double factor = tolerance / bound * (1.0 - tolerance::smoothTubeRounding);
  std::vector<Vec3> control(original.control());
  for (std::size_t i = 0; i < control.size(); ++i) {
    control[i] += factor * (moved.control()[i] - original.control()[i]);
  }
  spline::CubicSpline curve = original.withControl(std::move(control));
  const double deviation = deviationBound(original, curve, certificateHalvings);
  return {std::move(curve), deviation, 0};
}

Result<Smoothed> smooth(const spline::CubicSpline& curve, const Options& options) {
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance)) {
    return fail(diag::SmoothTolerance, options.tolerance);
  }
  if (!(options.accuracy > 0.0 && options.accuracy < 1.0) || options.precision < 1) {
    return fail(diag::SmoothSettings, options.precision, 100.0 * options.accuracy);
  }
  switch (options.method) {
    case Method::source:
      return sourceMethod(curve, options);
    case Method::tube:
      return tubeMethod(curve, options);
    case Method::time:
      return timeMethod(curve, options);
  }
  return Smoothed{curve, 0.0, 0};
}

double machiningTime(const spline::CubicSpline& curve, const timing::Limits& limits) {
  double time = 0.0;
  for (std::size_t first = 0; first < curve.spans(); first += timedSpans) {
    timing::SpeedLimits path;
    path.freeEnds = true;
    timing::appendSpans(path, curve, first, std::min(timedSpans, curve.spans() - first),
                        samplesOfASpan, limits.velocity, limits.acceleration);
    path.corners.push_back(limits.velocity);
    time += timing::Plan(std::move(path), limits).duration();
  }
  return time;
}

}  // namespace arelem::smooth
