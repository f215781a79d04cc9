#pragma once
#include <optional>
#include <span>
#include <string>

#include "runtime/motion/startup_faults.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// One surface of a startup as its direction sees it.
struct LedTo {
  std::string surface;
  ir::Condition condition = ir::Condition::to;
};

/// Whether a startup goes the way that INDIRV or INDIRP gave for a surface: 0 to 90 degrees off.
struct Sense {
  double back = 0.0;     ///< by which it goes against the direction, part unit; 0 where it does not
  double degrees = 0.0;  ///< between the way and the direction
};

/// The direction, either way, of a path along drive and part surface; zero where a startup has not
/// both of them.
[[nodiscard]] Vec3 pathOf(std::span<const StartupGoal> goals, const Vec3& near, const Vec3& axis);

/// Where a startup begins its search.
struct Led {
  Vec3 toolEnd;
  /// As far along a direction that misses its surface as the farthest surface is off (spec 4.7):
  /// looked from where what is met from the start lies behind it.
  std::optional<Vec3> beyond;
};

/// Steps of a directed startup towards its surfaces, in the order drive, part, check. A direction
/// that leads to its surface from where the tool stands, but misses it behind the steps before, is
/// met by these.
[[nodiscard]] Led leadOf(const State& state, std::span<const StartupGoal> goals);
[[nodiscard]] bool allPlanes(std::span<const StartupGoal> goals);

/// A tool end and the axis there.
struct Place {
  Vec3 toolEnd;
  Vec3 axis;
};

/// The normal of the plane through the start that holds the direction given for one of two surfaces
/// and is as square as can be to the path along both: to the one's normal where the direction
/// leads, the other's where the tool stands. None where neither surface is a plane: there the
/// direction leads near the position, and the nearest one is taken (manual 14.2.1).
[[nodiscard]] std::optional<Vec3> guidePlane(std::span<const StartupGoal> goals,
                                             const Vec3& direction,
                                             std::size_t given,
                                             const Place& led,
                                             const Place& start);

/// `flat`: only what is square to the axis counts, as on the plane route, where the part surface
/// sets the height. A way back shorter than the surface's tolerance band is none.
[[nodiscard]] Sense senseOf(
    const State& state, const Vec3& direction, const Vec3& toolEnd, Role role, bool flat);

/// The only place along the direction lies behind the tool (spec 4.7 and manual 14.2.2: the motion
/// is always forward along INDIRV).
[[nodiscard]] Failure behind(const LedTo& goal, const Vec3& toolEnd, const Sense& sense);
/// The direction was a guide only, and the startup goes against it.
[[nodiscard]] Failure turnsBack(const LedTo& goal, const Sense& sense);

}  // namespace arelem::motion
