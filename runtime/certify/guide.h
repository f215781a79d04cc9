#pragma once
#include <span>
#include <string>

#include "ir/limits.h"
#include "runtime/certify/modal.h"
#include "runtime/certify/prove.h"

namespace arelem::certify {

/// A location of the tool.
struct Location {
  Vec3 toolEnd = Vec3::Zero(), axis = Vec3::UnitZ();
};

/// One surface that a motion is to keep to.
struct GuideTask {
  Named surface;
  const tool::Profile* cutter = nullptr;  ///< null: the tool end is to be on the surface
  double thick = 0.0;
  Allowed allowed;
  /// Beyond the band by which the place where a motion begins may be off (spec 4.8).
  double startSlack = 0.0;
};

/// What was proven of a motion along one surface.
struct GuideResult {
  Verdict verdict;    ///< the worst of all cut vectors
  double side = 1.0;  ///< of the surface, by its normal, on which the tool is
  std::size_t leastVector = 0, greatestVector = 0;  ///< cut vectors, counted from 0
  Vec3 leastPlace = Vec3::Zero(), greatestPlace = Vec3::Zero();
  Vec3 firstNormal = Vec3::UnitZ();  ///< of the contact at the beginning
  double startGap = 0.0;             ///< at the place where the motion begins
};

/// Proves the tolerance of one surface along a path, path[0] being where the motion begins. The
/// tool is taken to stand on the side of the surface that it is nearer to; where both sides would
/// do, and for a tool end on the surface, on the one that keeps the tolerance.
[[nodiscard]] GuideResult proveGuide(const GuideTask& task,
                                     std::span<const Location> path,
                                     const InterruptFlag* interrupted);

/// The contact of the tool at one place with one side of a surface.
struct Touch {
  double low = 0.0, high = 0.0;  ///< the gap lies between
  Vec3 normal = Vec3::UnitZ();
};
[[nodiscard]] Touch touch(const surface::AnySurface& surface,
                          const Relation& relation,
                          const Location& at,
                          const Allowed& allowed);

}  // namespace arelem::certify
