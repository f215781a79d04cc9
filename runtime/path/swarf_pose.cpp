#include "runtime/path/swarf_pose.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/space/tolerance.h"

namespace arelem::path {

namespace {
Vec3 leftOf(const Vec3& forward) {
  return {-forward.y(), forward.x(), 0.0};
}

/// A wall: the plane `normal` . x = `distance`; the normal points into its material.
struct Wall {
  Vec3 normal;
  double distance;
};

/// The wall of a tool at `upright`, tilted as the tool is.
Wall wallOf(const SwarfTool& tool, const Vec3& upright, const Vec3& forward, double tilt) {
  const Vec3 side = tool.wallLeft ? leftOf(forward) : Vec3(-leftOf(forward));
  const double towards = tool.wallLeft ? tilt : -tilt;
  const Vec3 normal = std::cos(towards) * side - std::sin(towards) * Vec3::UnitZ();
  return {normal, normal.dot(upright + tool.radius * side)};
}

/// How high the tool end stands over the tool's lowest point, for an axis that leans by `lean`.
double rise(const SwarfTool& tool, double lean) {
  return (tool.radius - tool.corner) * std::sin(lean) + tool.corner * (1.0 - std::cos(lean));
}

double leanOf(const Vec3& axis) {
  return std::atan2(std::hypot(axis.x(), axis.y()), axis.z());
}

/// How far a tool reaches along the normal of a wall of which only the heights up to `top` are
/// there.
double reach(const SwarfTool& tool, const SwarfPose& pose, const Wall& wall, double top) {
  const double along = wall.normal.dot(pose.axis);
  const Vec3 across = wall.normal - along * pose.axis;
  const double share = across.norm();
  const double bottom = wall.normal.dot(pose.toolEnd + tool.corner * pose.axis) +
                        (tool.radius - tool.corner) * share + tool.corner;
  if (along <= 0.0 || share < tolerance::singular) {
    return bottom;
  }
  // Leaning over the wall: the flank is nearest at the top of the wall.
  const Vec3 foot = pose.toolEnd + tool.radius / share * across;
  const double t = std::max((top - foot.z()) / pose.axis.z(), tool.corner);
  return std::max(bottom, wall.normal.dot(foot + t * pose.axis));
}

/// Along the own wall until the other one is touched.
SwarfPose intoCorner(const SwarfTool& tool,
                     const SwarfCorner& corner,
                     const Vec3& axis,
                     const Wall& own,
                     const Wall& other,
                     const Vec3& towards) {
  SwarfPose pose;
  pose.axis = axis;
  pose.toolEnd = corner.upright;
  pose.toolEnd.z() += rise(tool, leanOf(axis));
  // Level, square to the motion: onto the own wall.
  const Vec3 side(own.normal.x(), own.normal.y(), 0.0);
  const double gap = own.distance - tool.radius - own.normal.dot(pose.toolEnd);
  pose.toolEnd += gap / side.squaredNorm() * side;
  const double free = other.distance - reach(tool, pose, other, corner.upright.z() + corner.height);
  pose.toolEnd += free / other.normal.dot(towards) * towards;
  return pose;
}
}  // namespace

namespace {
/// From the upright tool end to that of the tool tilted to the left.
Vec3 shift(const SwarfTool& tool, const Vec3& left, double tilt) {
  const Vec3 side = tool.wallLeft ? left : Vec3(-left);
  const double towards = tool.wallLeft ? tilt : -tilt;
  const double up =
      tool.deep && towards < 0.0 ? -tool.radius * std::sin(-towards) : rise(tool, std::abs(tilt));
  const double away = (tool.radius - up * std::sin(towards)) / std::cos(towards);
  return (tool.radius - away) * side + up * Vec3::UnitZ();
}
}  // namespace

SwarfPose swarfPose(const SwarfTool& tool, const Vec3& upright, const Vec3& forward, double tilt) {
  const Vec3 left = leftOf(forward);
  return {upright + shift(tool, left, tilt),
          std::cos(tilt) * Vec3::UnitZ() + std::sin(tilt) * left};
}

Vec3 swarfUpright(const SwarfTool& tool, const SwarfPose& pose, const Vec3& left, double tilt) {
  return pose.toolEnd - shift(tool, left, tilt);
}

std::optional<SwarfTurn> swarfTurn(const SwarfTool& tool, const SwarfCorner& corner) {
  const Wall first = wallOf(tool, corner.upright, corner.before, corner.tiltBefore);
  const Wall second = wallOf(tool, corner.upright, corner.after, corner.tiltAfter);
  Vec3 meeting = first.normal.cross(second.normal);
  if (meeting.norm() < tolerance::singular) {
    return std::nullopt;
  }
  meeting = meeting.normalized() * (meeting.z() < 0.0 ? -1.0 : 1.0);
  if (leanOf(meeting) >= steepestSwarf * std::numbers::pi / 180.0) {
    return std::nullopt;
  }
  const Vec3 start = swarfPose(tool, corner.upright, corner.before, corner.tiltBefore).axis;
  const Vec3 end = swarfPose(tool, corner.upright, corner.after, corner.tiltAfter).axis;
  SwarfTurn turn;
  for (int i = 0; i <= corner.steps; ++i) {
    const double share = static_cast<double>(i) / corner.steps;
    const Vec3 axis = ((1.0 - share) * start + share * meeting).normalized();
    turn.before.push_back(intoCorner(tool, corner, axis, first, second, corner.before));
  }
  for (int i = 1; i <= corner.steps; ++i) {
    const double share = static_cast<double>(i) / corner.steps;
    const Vec3 axis = ((1.0 - share) * meeting + share * end).normalized();
    turn.after.push_back(intoCorner(tool, corner, axis, second, first, -corner.after));
  }
  return turn;
}

}  // namespace arelem::path
