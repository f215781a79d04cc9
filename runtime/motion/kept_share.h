#pragma once
#include "runtime/motion/path.h"

namespace arelem::motion {

/// For cut vectors that no curvature limits: where the contact runs along a crest the gap at the
/// ends and in the middle tells nothing of a dip that the tool passes between them.
class KeptShare {
 public:
  /// How far along the cut vector from `a` to `b` every one of many places keeps the bands, as a
  /// share of its length; 1 for all of it. Of cut vectors one behind the other whose contacts are
  /// alike, on the straight ends of a surface, most are looked at in fewer places.
  [[nodiscard]] double of(Path& path, const PathPoint& a, const PathPoint& b);

 private:
  [[nodiscard]] static double firstOff(Path& path, const PathPoint& a, const PathPoint& b, int by);
  [[nodiscard]] bool isLikeLast(const PathPoint& a, const PathPoint& b) const;

  /// Normals where the last one that kept its bands began.
  std::array<Vec3, 2> last_{Vec3::Zero(), Vec3::Zero()};
  int fewer_ = 0;  ///< such cut vectors since the last one that was looked at in all places
};

}  // namespace arelem::motion
