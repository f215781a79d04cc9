// Tilted tools along walls. Locations measured with the old system, and the walls themselves.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/path/swarf_pose.h"

namespace arelem::path {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Measured {
  SwarfTool tool;
  double tilt;  ///< degrees, positive to the left
  double y, z;  ///< of the tool end; the path goes along x, the wall along the x axis
};

TEST(SwarfPose, AgreesWithTheOldSystem) {
  const std::vector<Measured> cases = {
      {{1.0, 0.0, true, false}, 10, -0.984808, 0.173648},
      {{1.0, 0.0, true, false}, -10, -1.046045, 0.173648},
      {{1.0, 0.0, true, true}, -10, -0.984808, -0.173648},
      {{1.0, 0.5, true, false}, 10, -0.998778, 0.094420},
      {{1.0, 0.5, true, false}, -10, -1.032075, 0.094420},
      {{1.0, 1.0, true, false}, 10, -1.012748, 0.015192},
      {{1.0, 0.0, false, false}, 10, 1.046045, 0.173648},
      {{1.0, 0.0, false, false}, -10, 0.984808, 0.173648},
  };
  for (const Measured& c : cases) {
    const Vec3 upright(10.0, c.tool.wallLeft ? -1.0 : 1.0, 0.0);
    const SwarfPose pose = swarfPose(c.tool, upright, Vec3::UnitX(), c.tilt * degree);
    EXPECT_NEAR(pose.toolEnd.x(), 10.0, 1e-12);
    EXPECT_NEAR(pose.toolEnd.y(), c.y, 1e-6);
    EXPECT_NEAR(pose.toolEnd.z(), c.z, 1e-6);
    EXPECT_NEAR(pose.axis.y(), std::sin(c.tilt * degree), 1e-12);
  }
}

/// Deepest point of the tool behind a wall of which the heights up to `top` are there.
double depth(
    const SwarfTool& tool, const SwarfPose& pose, const Vec3& normal, const Vec3& on, double top) {
  double deepest = -1e9;
  const Vec3 u = pose.axis.unitOrthogonal();
  const Vec3 v = pose.axis.cross(u);
  for (double up = tool.corner; up < 8.0; up += 0.01) {
    for (double turn = 0.0; turn < 360.0; turn += 1.0) {
      const Vec3 p = pose.toolEnd + up * pose.axis +
                     tool.radius * (std::cos(turn * degree) * u + std::sin(turn * degree) * v);
      deepest = p.z() <= top ? std::max(deepest, normal.dot(p - on)) : deepest;
    }
  }
  return deepest;
}

/// Walls along the x axis (below the path) and along x = 10, in that order; the corner is an inside
/// one. Tilts in degrees to the left of the motion.
void checkCorner(double before, double after, double height) {
  const SwarfTool tool{1.0, 0.0, false, false};
  const SwarfCorner corner{
      {9.0, 1.0, 0.0}, Vec3::UnitX(), Vec3::UnitY(), before * degree, after * degree, height, 4};
  const auto turn = swarfTurn(tool, corner);
  ASSERT_TRUE(turn);
  ASSERT_EQ(turn->before.size(), 5);
  ASSERT_EQ(turn->after.size(), 4);
  // A wall leans as the tool does: to the left is over the wall's foot, towards the tool.
  const Vec3 first(0.0, -std::cos(before * degree), std::sin(before * degree));
  const Vec3 second(std::cos(after * degree), 0.0, std::sin(after * degree));
  const auto check = [&](const SwarfPose& pose, const Vec3& own, const Vec3& other) {
    EXPECT_NEAR(pose.axis.dot(own), 0.0, 1e-12);
    const Vec3 foot(10.0, 0.0, 0.0);
    EXPECT_NEAR(depth(tool, pose, own, foot, height), 0.0, 1e-3);
    EXPECT_NEAR(depth(tool, pose, other, foot, height), 0.0, 5e-3);
  };
  for (const SwarfPose& pose : turn->before) {
    check(pose, first, second);
  }
  for (const SwarfPose& pose : turn->after) {
    check(pose, second, first);
  }
  EXPECT_NEAR(turn->before.front().axis.y(), std::sin(before * degree), 1e-12);
  EXPECT_NEAR(turn->after.back().axis.x(), -std::sin(after * degree), 1e-12);
}

TEST(SwarfCorner, TheToolTouchesBothWallsAndEntersNone) {
  checkCorner(0, 0, 3);
  checkCorner(10, 10, 3);    // both walls hang over
  checkCorner(-10, -10, 3);  // both lean back
  checkCorner(10, -6, 2);
  checkCorner(-5, 12, 2);
}

TEST(SwarfCorner, WallsInOnePlaneMeetInNoLine) {
  EXPECT_FALSE(swarfTurn({1.0, 0.0, false, false},
                         {{0.0, 0.0, 0.0}, Vec3::UnitX(), Vec3::UnitX(), 0.0, 0.0, 1.0, 6}));
}

TEST(SwarfPose, GoesBackToTheUprightTool) {
  const Vec3 upright(3.0, -4.0, 7.0);
  const Vec3 forward = Vec3(2.0, 1.0, 0.0).normalized();
  const Vec3 left(-forward.y(), forward.x(), 0.0);
  for (const SwarfTool tool : {SwarfTool{5.0, 0.0, true, false}, SwarfTool{5.0, 2.0, false, false},
                               SwarfTool{5.0, 0.0, true, true}}) {
    for (const double tilt : {-1.2, -0.3, 0.0, 0.2, 1.0}) {
      const SwarfPose pose = swarfPose(tool, upright, forward, tilt);
      EXPECT_LT((swarfUpright(tool, pose, left, tilt) - upright).norm(), 1e-12) << tilt;
    }
  }
}

}  // namespace
}  // namespace arelem::path
