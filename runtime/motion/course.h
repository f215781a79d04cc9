#pragma once
#include <vector>

#include "runtime/motion/follow.h"
#include "runtime/motion/path.h"

namespace arelem::motion {

/// What one motion runs along: the path of both guiding surfaces, the watches of the check
/// surfaces, and the start.
struct Course {
  Path path;
  NamedSurface part, drive;
  std::vector<CheckWatch> watches;  ///< in the order of the request
  PathPoint start;                  ///< where the tool comes to the motion, with its axis there
  bool turnsFirst = false;          ///< the tool comes with an axis that is not the rule's
  bool exact = false;               ///< plane route: stops are exact
  bool onDrive = false;             ///< TLON
  std::vector<Failure> warnings;

  [[nodiscard]] Guide& partGuide() { return path.guides[partRole]; }
  [[nodiscard]] Guide& driveGuide() { return path.guides[driveRole]; }
  /// A circle of the plane route is divided evenly.
  [[nodiscard]] bool isArc() const {
    return exact && std::holds_alternative<surface::Cylinder>(drive.surface);
  }
};

/// Sets up a motion from the state's tool position and checks that it can start (502 to 505 of the
/// old system).
[[nodiscard]] Result<Course> planCourse(const State& state, const FollowRequest& request);

}  // namespace arelem::motion
