#pragma once
#include <span>

#include "runtime/spline/cubic.h"

namespace arelem::spline {

/// The curve with continuous curvature through all points, with knots at the chord lengths.
/// Open: natural ends (no curvature there). Closed: the last point is not repeated.
/// Errors: fewer than 2 (closed: 4) points, successive points that coincide.
[[nodiscard]] Result<CubicSpline> interpolate(std::span<const Vec3> points, bool closed);

/// The curve whose control points lie on the polyline through the points, so close to each other
/// that it is nowhere farther than `tolerance` from it. It lies in the convex hulls of its own
/// polygon: it never overshoots a corner. Linear in the number of control points.
/// Errors: fewer than 2 points, coincident neighbors.
[[nodiscard]] Result<CubicSpline> followPolyline(std::span<const Vec3> points,
                                                 double tolerance,
                                                 bool closed);

/// The curve of few control points that passes every point within `tolerance` (least squares over
/// chord lengths; spans that miss are halved until none does). Open: it begins and ends in the end
/// points. Closed: the last point is not repeated. Errors: as above.
[[nodiscard]] Result<CubicSpline> approximate(std::span<const Vec3> points,
                                              double tolerance,
                                              bool closed = false);

}  // namespace arelem::spline
