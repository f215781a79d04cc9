#pragma once
#include <vector>

#include "runtime/geometry/shapes.h"

namespace arelem::spray {

using geometry::Vec2;

/// One closed boundary, closed by itself. Outlines run counterclockwise, holes clockwise: what is
/// painted lies to the left.
using Loop = std::vector<Vec2>;

/// What is painted, in its plane, mm: any number of outlines with holes that do not cross.
struct Outline {
  std::vector<Loop> loops;
};

/// Area, mm2: holes count negative. Source: Bartlett appendix A.
[[nodiscard]] double areaOf(const Outline& outline);
/// The same outline turned by an angle about the origin, radians counterclockwise.
[[nodiscard]] Outline turned(const Outline& outline, double angle);

struct Extent {
  Vec2 low = Vec2::Zero();
  Vec2 high = Vec2::Zero();
};
[[nodiscard]] Extent extentOf(const Outline& outline);

/// Where the horizontal line at `height` crosses a loop, in order: an edge counts where exactly one
/// end is at or below the height, so that a vertex counts once when the loop goes on and not at all
/// at a peak. The source's strict rule (3.4) misses such vertices.
[[nodiscard]] std::vector<double> hits(const Loop& loop, double height);

}  // namespace arelem::spray
