#include "backend/vplus/held_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/robot.h"
#include "ir/space/robot_tolerance.h"

namespace arelem::vplus {

using namespace robot;

std::optional<Objection> hold(const Machine& machine,
                              const Pose& pose,
                              std::string_view place,
                              HeldTool& held) {
  held.written = pose;
  held.inBase = inBase(machine.frame, pose);
  if (!machine.scara && !machine.tilt) {
    return std::nullopt;
  }
  const std::optional<Upright> upright = uprightOf(held.inBase);
  const double lean = std::acos(std::clamp(held.inBase.axis.normalized().z(), -1.0, 1.0)) * 180.0 /
                      std::numbers::pi;
  if (!upright || (!machine.tilt && lean > tolerance::uprightLean)) {
    return Objection{fail(diag::ToolNotUpright, place, lean,
                          machine.tilt ? " but for the tilt along its side" : ""),
                     lean};
  }
  if (machine.tilt) {
    const double excess = std::abs(upright->tilt) - machine.tilt->most;
    if (excess > tolerance::uprightLean) {
      return Objection{fail(diag::TiltRange, place, upright->tilt, machine.tilt->most, excess),
                       excess};
    }
    held.tiltWord = tiltWord(*machine.tilt, upright->tilt);
  }
  if (pose.side) {
    const auto& angles = machine.frame.angles;
    const Vec3 third = pose.axis.cross(*pose.side);
    held.written.axis = matrixOf({angles[0], angles[1], angles[2]}).transpose() * Vec3::UnitZ();
    held.written.side = third.cross(held.written.axis);
    held.inBase = inBase(machine.frame, held.written);
  }
  return std::nullopt;
}

Pose raised(Pose pose, double away) {
  pose.point += away * pose.axis.normalized();
  return pose;
}

}  // namespace arelem::vplus
