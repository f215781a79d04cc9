#pragma once
#include "runtime/spline/cubic.h"
#include "runtime/timing/plan.h"

namespace arelem::timing {

/// Appends the pieces of a curve: `perSpan` for each knot interval, each limited by `feed` and by
/// the speed v = sqrt(A / k) that its largest sampled curvature allows. Corners inside are free.
void appendCurve(SpeedLimits& path,
                 const spline::CubicSpline& curve,
                 int perSpan,
                 double feed,
                 double acceleration);
/// The same for so many knot intervals from one on.
void appendSpans(SpeedLimits& path,
                 const spline::CubicSpline& curve,
                 std::size_t first,
                 std::size_t count,
                 int perSpan,
                 double feed,
                 double acceleration);

/// Speed on a circle of curvature k under an acceleration towards its center. Source: Naseath, eq.
/// 3-3.
[[nodiscard]] double curveSpeed(double curvature, double acceleration);

/// Speed through a corner of a polyline that turns by `cosine`, when the path may leave it by
/// `deviation`: that of the circle that touches both legs and passes the corner there, and touches
/// them no farther from it than half of `shorter`, their shorter length, so that corners of fine
/// chords cost what the curve costs that they stand for.
[[nodiscard]] double cornerSpeed(double cosine,
                                 double deviation,
                                 double acceleration,
                                 double shorter);

}  // namespace arelem::timing
