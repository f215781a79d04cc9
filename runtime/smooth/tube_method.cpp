// Smooth paths by the tube of tube.h: of the least largest curvature, and of the least time.
#include <algorithm>
#include <array>
#include <vector>

#include "runtime/smooth/smooth.h"
#include "runtime/smooth/tube_solver.h"

namespace arelem::smooth {

namespace {

using spline::CubicSpline;

constexpr Schedule leastCurvature{2.0, 8, 8};
/// From the path of a few control points to those of more, each begun where the one before ended.
constexpr std::array leastTime = {Schedule{0.5, 6, 6}, Schedule{2.0, 6, 6}, Schedule{5.0, 6, 8}};
/// Samples of each knot interval when curves are compared.
constexpr int samplesOfASpan = 6;
/// Where a curve is too sharp for the feed, so many knot intervals on each side are refined with
/// it.
constexpr std::size_t besideSharp = 2;

/// The knot intervals whose curvature does not allow the feed, and those beside them.
std::vector<bool> sharpSpans(const CubicSpline& curve, const timing::Limits& limits) {
  const double allowed = limits.acceleration / (limits.velocity * limits.velocity);
  const std::size_t spans = curve.spans();
  std::vector<bool> marked(spans, false);
  for (std::size_t i = 0; i < spans; ++i) {
    const spline::Bezier piece = curve.piece(i);
    const double most = std::max({piece.curvature(piece.begin), piece.curvature(piece.end),
                                  piece.curvature(0.5 * (piece.begin + piece.end))});
    if (most <= allowed) {
      continue;
    }
    // A closed curve goes on at its other end; an open one does not.
    for (std::size_t k = 0; k <= 2 * besideSharp; ++k) {
      const std::size_t at = i + spans + k - besideSharp;
      if (curve.closed() || (at >= spans && at < 2 * spans)) {
        marked[at % spans] = true;
      }
    }
  }
  return marked;
}

bool interrupted(const Options& options) {
  return options.interrupted != nullptr && options.interrupted->load(std::memory_order_relaxed);
}

}  // namespace

Smoothed tubeMethod(const CubicSpline& curve, const Options& options) {
  // Twice the control points: room to bend later and less.
  const CubicSpline original = curve.refined();
  const std::vector<Vec3> shift =
      displaced(original, opened(original, options.tolerance), leastCurvature, options);
  Smoothed now = guarded(original, shifted(original, shift), options.tolerance);
  now.iterations = leastCurvature.rounds * leastCurvature.turns;
  const bool isBetter = curvatureFigures(now.curve, samplesOfASpan).most <
                        curvatureFigures(original, samplesOfASpan).most;
  return isBetter ? std::move(now) : Smoothed{original, 0.0, now.iterations};
}

Smoothed timeMethod(const CubicSpline& curve, const Options& options) {
  Smoothed best{curve, 0.0, 0};
  double least = machiningTime(curve, options.limits);
  CubicSpline original = curve;
  CubicSpline now = curve;
  std::vector<Vec3> shift(curve.control().size(), Vec3::Zero());
  int iterations = 0;
  for (const Schedule& schedule : leastTime) {
    const std::vector<bool> sharp = sharpSpans(now, options.limits);
    const bool isFirst = iterations == 0;
    if (interrupted(options) || (!isFirst && std::ranges::find(sharp, true) == sharp.end())) {
      break;
    }
    // The difference of two curves takes more knots as they do.
    shift = original.withControl(std::move(shift)).refined(sharp).control();
    original = original.refined(sharp);
    shift = displaced(original, isFirst ? opened(original, options.tolerance) : shift, schedule,
                      options);
    Smoothed moved = guarded(original, shifted(original, shift), options.tolerance);
    iterations += schedule.rounds * schedule.turns;
    now = moved.curve;
    const double time = machiningTime(now, options.limits);
    if (time < least) {
      least = time;
      best = std::move(moved);
    }
  }
  best.iterations = iterations;
  return best;
}

}  // namespace arelem::smooth
