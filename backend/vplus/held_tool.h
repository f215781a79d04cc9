#pragma once
#include <optional>
#include <string_view>

#include "backend/robot/machine.h"
#include "backend/robot/objections.h"
#include "backend/robot/pose.h"

namespace arelem::vplus {

/// What a robot makes of a pose of the path: the pose that its program has, where a robot of four
/// axes holds the tool upright, and the word of its tilt axis.
struct HeldTool {
  robot::Pose written;  ///< seen from the frame
  robot::Pose inBase;   ///< the same, seen from the base
  int tiltWord = 0;
};
/// Objections: E0664 a tool that leans, E0665 a tilt beyond the axis.
[[nodiscard]] std::optional<robot::Objection> hold(const robot::Machine& machine,
                                                   const robot::Pose& pose,
                                                   std::string_view place,
                                                   HeldTool& held);
/// The pose moved away from the work along the tool, mm.
[[nodiscard]] robot::Pose raised(robot::Pose pose, double away);

}  // namespace arelem::vplus
