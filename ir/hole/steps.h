#pragma once
#include <vector>

#include "ir/hole/cycle.h"
#include "ir/space/vector.h"

namespace arelem::hole {

/// One move along the tool axis, or a wait.
struct Step {
  enum class Kind : std::uint8_t { rapid, feed, dwell };
  Kind kind = Kind::rapid;
  double height = 0.0;   ///< of the tool end over the location, in the unit of the cycle
  double seconds = 0.0;  ///< of a dwell
};

/// A cycle at one location, move by move: from the clearance to the bottom, peck by peck where it
/// has pecks, and back to the clearance, or higher where the cycle retracts. BRKCHP leaves the hole
/// between its pecks as DEEP does, which breaks chips as well. Error E0673: TAP, whose spindle
/// turns back at the bottom, which no move can say.
[[nodiscard]] Result<std::vector<Step>> stepsOf(const Cycle& cycle);

/// The same for any cycle, as long as it takes: TAP goes back at its feed.
[[nodiscard]] std::vector<Step> timedStepsOf(const Cycle& cycle);

/// The way of the tool end to a place over a hole, without a change of the axis: along the
/// axis up to its height if it is below it, then across, at the height where it is.
[[nodiscard]] std::vector<Vec3> wayOver(const Vec3& from, const Vec3& clear, const Vec3& axis);

}  // namespace arelem::hole
