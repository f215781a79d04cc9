#pragma once
#include "runtime/spray/surface/section_planes.h"

namespace arelem::spray {

class Walls;

/// The lines of a job, in the order in which they are sprayed.
struct LaidLines {
  std::vector<SurfaceLine> lines;
  std::vector<std::size_t> ranks;  ///< of each line: which of `whole`, or which section it is of
  std::vector<SurfaceLine> whole;  ///< of u or v, before planes cut them; empty for sections
  SectionPlanes sections;          ///< of sections
  double step = 0.0;               ///< mm, where they are farthest apart
  std::size_t leftOut = 0;         ///< lines too short to be sprayed
  double shortest = HUGE_VAL;      ///< the length of the shortest of them
};

/// Lays lines at most `widest` apart, and makes them longer where the job asks for it. `walls` may
/// be null. Errors: E0358, E0375.
[[nodiscard]] Result<LaidLines> layLines(const SurfaceJob& job, double widest, const Walls* walls);

/// Error E0349 where the gun would go through the work, on a line or between it and the work.
[[nodiscard]] std::optional<Failure> objectionToWalls(const std::vector<SurfaceLine>& lines,
                                                      double standOff,
                                                      const Walls& walls);

}  // namespace arelem::spray
