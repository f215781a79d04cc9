#include "runtime/smooth/smooth.h"

#include <cmath>

#include "ir/diag/spline.h"

namespace arelem::smooth {

namespace {
/// Halvings of each knot interval when the deviation is certified.
constexpr int certificateHalvings = 2;
}  // namespace

Smoothed guarded(const spline::CubicSpline& original,
                 const spline::CubicSpline& moved,
                 double tolerance) {
  const double bound = deviationBound(original, moved, certificateHalvings);
  if (bound <= tolerance) {
    return {moved, bound, 0};
  }
  // A hair less than the quotient, so that rounding does not lift the result over the tolerance.
  constexpr double hair = 1.0 - 1e-12;
  const double factor = tolerance / bound * hair;
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
  return options.method == Method::source ? sourceMethod(curve, options)
                                          : tubeMethod(curve, options);
}

}  // namespace arelem::smooth
