#pragma once
#include "runtime/spray/surface/surface_lines.h"

namespace arelem::spray {

class Walls;

/// Where a line that ends there does not go on: at planes that it has reached.
using Ends = std::vector<HalfSpace>;

/// How lines go on straight beyond the edges of the work (PAST). mm.
struct Past {
  double length = 0.0;
  double standOff = 0.0;         ///< of the nozzle, which must not go through a wall either
  const Walls* walls = nullptr;  ///< null: there are none
};

/// Makes an open line longer at its ends. An end stays where it is at one of `ends`, where `onEdge`
/// is false, and where the way on would lead through a wall.
void goPast(SurfaceLine& line,
            const Past& past,
            const Ends& ends,
            const std::function<bool(const LinePoint&)>& onEdge);

/// A line beside one that runs along an edge, so far from it to the side to which `outside` points
/// at the line's middle.
[[nodiscard]] SurfaceLine beside(const SurfaceLine& line, double distance, const Vec3& outside);

/// Length of a line, mm.
[[nodiscard]] double lengthOf(const SurfaceLine& line);

}  // namespace arelem::spray
