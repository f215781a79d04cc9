#pragma once
#include <span>
#include <vector>

#include "runtime/geometry/shapes.h"

/// Polygons in exact arithmetic (CGAL): areas are rounded once, at the end, and whether edges meet
/// is decided without rounding.
namespace arelem::geometry {

using Polygon = std::vector<Vec2>;  ///< corners in order, closed by itself

/// Sum of the areas of polygons; those that run clockwise count negative.
[[nodiscard]] double signedArea(std::span<const Polygon> polygons);

/// Two edges that meet where they must not.
struct Meeting {
  Vec2 place = Vec2::Zero();
  std::size_t polygon = 0, otherPolygon = 0;  ///< from 0
  std::size_t edge = 0, otherEdge = 0;  ///< from 0; an edge begins at the corner of its number
};
/// The first edges, in the order of the corners, that cross, touch or lie on each other, other than
/// neighbors at their common corner. Edges of two polygons also meet where a corner of one lies
/// within `near` of the other: 0 decides without rounding.
[[nodiscard]] std::optional<Meeting> firstMeeting(std::span<const Polygon> polygons,
                                                  double near = 0.0);

}  // namespace arelem::geometry
