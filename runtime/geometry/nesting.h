#pragma once
#include <span>
#include <vector>

#include "runtime/geometry/exact_polygon.h"

namespace arelem::geometry {

/// In how many others each polygon lies. None of them may meet another or itself (`firstMeeting`).
/// A line is swept over all corners from left to right; which edge lies under which is decided
/// without rounding. Time goes with n log n of the corners. Source: Shamos and Hoey (1976), the
/// order of the edges along a sweep line.
[[nodiscard]] std::vector<std::size_t> nestingDepths(std::span<const Polygon> polygons);

}  // namespace arelem::geometry
