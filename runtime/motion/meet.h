#pragma once
#include "runtime/motion/check_watch.h"
#include "runtime/motion/path.h"

namespace arelem::motion {

/// Where on the path a check surface is met, from a bracket on the segment after `from`;
/// `checkRest` is the gap to leave there, not used for touches. None where the path cannot be
/// followed so far.
[[nodiscard]] std::optional<PathPoint> meet(Path& path,
                                            const PathPoint& from,
                                            const Segment& segment,
                                            const CheckWatch& watch,
                                            const CheckWatch::Hit& hit,
                                            double checkRest);

}  // namespace arelem::motion
