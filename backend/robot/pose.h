#pragma once
#include <optional>
#include <vector>

#include "backend/robot/machine.h"
#include "ir/cl/record.h"

namespace arelem::robot {

/// Where the tool stands: the tool point, the axis from it to the holder and, where the tool is not
/// round, its own x direction square to the axis.
struct Pose {
  Vec3 point = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  std::optional<Vec3> side;
};

/// The locations of a record, in millimeters.
[[nodiscard]] std::vector<Pose> posesOf(const cl::Motion& motion, double millimeters);

/// ZYZ angles about moving axes, R = Rz(yaw) Ry(pitch) Rz(roll), degrees; pitch 0 to 180.
struct Euler {
  double yaw = 0.0;
  double pitch = 0.0;
  double roll = 0.0;
};
[[nodiscard]] Matrix3 matrixOf(const Euler& angles);
/// Inverse; at pitch 0 and 180, where only one angle counts, yaw is 0.
[[nodiscard]] Euler eulerOf(const Matrix3& turn);

/// The tool frame of a robot: its z points out of the flange to the work, against the tool axis,
/// its x along the side; without a side the roll is 0.
[[nodiscard]] Matrix3 toolFrame(const Pose& pose);
[[nodiscard]] Pose poseOf(const Vec3& point, const Matrix3& toolFrame);

/// The tilt of a gun about the horizontal line square to its fan, and the pose without it: upright,
/// with the same heading. Degrees, positive towards the side. None where the tool leans otherwise.
struct Upright {
  double tilt = 0.0;
  double heading = 0.0;  ///< of the side seen from above, from x
};
[[nodiscard]] std::optional<Upright> uprightOf(const Pose& pose);

/// The pose as the base of the robot sees it.
[[nodiscard]] Pose inBase(const Frame& frame, const Pose& pose);

}  // namespace arelem::robot
