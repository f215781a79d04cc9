#pragma once
#include "backend/robot/pose.h"
#include "ir/diag/result.h"

/// Programs of Fanuc R-G2 controllers, whose blocks carry code G97. What is known of them: G. Sen,
/// RoboPaint (1997), chapters 3 and 4.
namespace arelem::g97 {

/// P, Q, R in degrees. The tool frame is Rx(P) Ry(Q) Rz(R) about moving axes, or Rz(R) Ry(Q) Rx(P)
/// about fixed ones; its z is the tool axis, which points from the work to the gun.
struct Angles {
  double p = 0.0, q = 0.0, r = 0.0;
};
[[nodiscard]] robot::Matrix3 matrixOf(const robot::G97Style& style, const Angles& angles);
/// -90 <= q <= 90, p and r in (-180, 180]. Without a side R is 0, or keeps the tool's x over the
/// direction that the axis leans to; where the axis lies along x, P is 0.
[[nodiscard]] Angles anglesOf(const robot::G97Style& style, const robot::Pose& pose);
/// Sen's equations (11) and (12), P = -atan(b/c) and Q = atan(a/c), and R = 0. Where c < 0 the
/// quadrant is mended: P turns the gun over, Q keeps the sign of a; as printed the gun would point
/// away from the work. Right where the axis leans about one of x and y only; (1, 1, 1) is missed by
/// 9.74 degrees.
[[nodiscard]] Angles robopaintAngles(const Vec3& axis);

/// The six numbers of a block, rounded to its two decimals.
struct BlockPose {
  Vec3 point = Vec3::Zero();
  Angles angles;
  [[nodiscard]] bool operator==(const BlockPose& other) const {
    return point == other.point && angles.p == other.angles.p && angles.q == other.angles.q &&
           angles.r == other.angles.r;
  }
};
/// What a block says for a pose of the part program, with the frame, tool and formulas of the
/// machine file. Error E0642: a coordinate that has no room.
[[nodiscard]] Result<BlockPose> blockOf(const robot::Machine& machine,
                                        const robot::Pose& pose,
                                        std::string_view place);
/// The pose of the part program that a block stands for.
[[nodiscard]] robot::Pose poseOf(const robot::Machine& machine, const BlockPose& block);

}  // namespace arelem::g97
