#pragma once
#include "runtime/motion/path.h"

namespace arelem::motion {

/// How far along the cut vector from `a` to `b` every one of many places keeps the bands, as a
/// share of its length; 1 for all of it. For cut vectors that no curvature limits: where the
/// contact runs along a crest the gap at the ends and in the middle tells nothing of a dip that the
/// tool passes between them.
[[nodiscard]] double keptShare(Path& path, const PathPoint& a, const PathPoint& b);

}  // namespace arelem::motion
