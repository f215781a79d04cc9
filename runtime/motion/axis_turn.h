#pragma once
#include <vector>

#include "runtime/motion/path.h"

namespace arelem::motion {

/// Turns the tool about the place where it stands from the axis with which it comes to the one of
/// the path's rule, in contact with both surfaces: the ends of as few cut vectors as the bands
/// allow, the last one on the path. Empty where the tool cannot turn there.
[[nodiscard]] std::vector<PathPoint> turnOntoPath(Path& path,
                                                  const PathPoint& from,
                                                  const Vec3& tangent);

}  // namespace arelem::motion
