#pragma once
#include <vector>

#include "backend/robot/turning.h"

namespace arelem::robot {

/// A place of a machine with turning axes: the pose of the tool and the angles that give it.
struct TurnedPlace {
  ToolPose pose;
  Angles angles{};
};

/// Degrees that the axis turns by that turns most.
[[nodiscard]] double turnBetween(const Angles& a, const Angles& b);

/// The places of a straight move whose tool axis turns evenly, the last one included: so many that
/// a machine which moves all axes evenly from place to place keeps the tool end and the tool axis
/// within the tolerances of `turning`. A move that leaves a pole, where any turn
/// about the tool holds it, begins with places that turn where the tool stands. Errors: as of
/// nextAngles; axes that would have to swing to another solution on the way (E0679).
[[nodiscard]] Result<std::vector<TurnedPlace>> turnedMove(const Turning& turning,
                                                          const TurnedPlace& from,
                                                          const ToolPose& to);

}  // namespace arelem::robot
