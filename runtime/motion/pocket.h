#pragma once
#include <vector>

#include "ir/diag/result.h"
#include "runtime/interpret/action.h"
#include "runtime/motion/records.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// The values of POCKET/Re,c,f,f1,f2,f3,o,p by name.
struct PocketOrder {
  double reach = 0.0;    ///< Re: the cutter clears what lies within it of the path
  double general = 0.0;  ///< between passes: c radii of the cutter
  double finish = 0.0;   ///< between the last general pass and the outer one: f radii
  double plungeFeed = 0.0, generalFeed = 0.0, finishFeed = 0.0;
  bool fixedSteps = false;  ///< o = 1: steps are never reduced
  bool wall = false;        ///< p = 1, 3: the points are on the wall
  bool projected = false;   ///< p = 2, 3: the points are projected to the part surface
};

struct PocketPlan {
  PocketOrder order;
  /// Tool ends of the passes from the innermost to the outer one; each is a closed polygon, the
  /// first vertex not repeated.
  std::vector<std::vector<Vec3>> passes;
  double missed = 0.0;  ///< how far the cutter stays away from what lies between two passes
};

/// Clears a convex pocket in passes parallel to its outline (spec 4.11). The steps are c radii;
/// with o = 0 they are reduced until nothing between two passes is farther than Re from them, and
/// the innermost pass is as far from the next as that needs, half a step where this suffices. Fails
/// with 3501 to 3519 of the old system.
[[nodiscard]] Result<PocketPlan> planPocket(const State& state, const runtime::Pocket& pocket);

struct PocketTotals {
  Vec3 first = Vec3::Zero(), beforeLast = Vec3::Zero(), last = Vec3::Zero();
  std::uint64_t cutVectors = 0;
  double length = 0.0;  ///< from the first place on
};

/// Puts the passes out with their feeds: to the first place of the innermost pass, along all passes
/// but the outer one, along the outer one. Each is closed and begins at the image of the first
/// point.
PocketTotals putPocket(
    const PocketPlan& plan, const Vec3& axis, bool output, bool withAxis, RecordWriter& writer);

}  // namespace arelem::motion
