#pragma once
#include "backend/robot/objections.h"
#include "backend/robot/pose.h"

namespace arelem::robot {

/// Joint angles of a SCARA, degrees, and the height of its quill, mm.
struct ScaraJoints {
  double joint1 = 0.0;
  double joint2 = 0.0;
  double height = 0.0;
  double joint4 = 0.0;
};

/// Closed inverse kinematics of a place within the reach; the elbow on the side that the machine
/// file names, joint 4 nearest to `joint4Before`.
[[nodiscard]] ScaraJoints jointsOf(const Scara& scara,
                                   const Vec3& point,
                                   double heading,
                                   double joint4Before);
/// What keeps the robot from a place: E0660 outside the reach, E0661 height, E0662 a joint beyond
/// its range; all by how much. `place` tells the pose in messages: "location 12".
[[nodiscard]] std::optional<Objection> objectionToPlace(const Scara& scara,
                                                        const Vec3& point,
                                                        double heading,
                                                        double joint4Before,
                                                        std::string_view place);
/// The tool point of joint angles.
[[nodiscard]] Vec3 pointOf(const Scara& scara, const ScaraJoints& joints);

/// A straight move keeps its elbow, so that its whole way must lie outside the inner circle of the
/// reach. Errors: E0663 by how much it comes too near; E0662 joint 1 or 2 beyond its range on the
/// way.
[[nodiscard]] std::optional<Objection> objectionToLine(const Scara& scara,
                                                       const Vec3& from,
                                                       const Vec3& to,
                                                       std::string_view place);
/// Radii between which the arm reaches, mm.
[[nodiscard]] Range reachOf(const Scara& scara);

}  // namespace arelem::robot
