// Ways of the gun between lines keep off the work; the distances here are those of the exact
// bodies.
#include "runtime/spray/surface/clear_ways.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/spray/surface/patch.h"
#include "tests/unit/runtime/spray/box_mesh.h"

namespace arelem::spray {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

Patch ball(double radius) {
  Patch p;
  p.at = [radius](double u, double v) {
    return Vec3(radius * std::cos(v) * std::cos(u), radius * std::cos(v) * std::sin(u),
                radius * std::sin(v));
  };
  p.bend = [radius](double) { return Patch::Bend{radius, radius, radius}; };
  p.u1 = turn;
  p.v0 = -turn / 4.0;
  p.v1 = turn / 4.0;
  return p;
}

Patch ring(double major, double minor) {
  Patch p;
  p.at = [major, minor](double u, double v) {
    const double arm = major + minor * std::cos(v);
    return Vec3(arm * std::cos(u), arm * std::sin(u), minor * std::sin(v));
  };
  p.bend = [major, minor](double) { return Patch::Bend{major + minor, minor, minor}; };
  p.u1 = p.v1 = turn;
  return p;
}

/// The smallest distance along the whole way.
double nearest(const GunPose& from,
               const std::vector<GunPose>& poses,
               const GunPose& to,
               const std::function<double(const Vec3&)>& distance) {
  std::vector<GunPose> all = {from};
  all.insert(all.end(), poses.begin(), poses.end());
  all.push_back(to);
  double least = HUGE_VAL;
  for (std::size_t i = 1; i < all.size(); ++i) {
    for (int k = 0; k <= 500; ++k) {
      const Vec3 way = all[i].place - all[i - 1].place;
      least = std::min(least, distance(all[i - 1].place + way * k / 500.0));
    }
  }
  return least;
}

TEST(ClearWays, AKnownBendBoundsTheTriangles) {
  const Walls walls = Walls::of(ball(100.0));
  EXPECT_GT(walls.blur(), 0.0);
  EXPECT_LT(walls.blur(), 1.0);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 at = ball(150.0).at(0.7 * i, -1.5 + 0.003 * i);
    EXPECT_NEAR(walls.from(at), 50.0, walls.blur());
  }
}

TEST(ClearWays, GoRoundABall) {
  const Walls walls = Walls::of(ball(100.0));
  const ClearWays ways(walls, 25.0);
  const auto over = [](const Vec3& p) { return p.norm() - 100.0; };
  const GunPose from = {Vec3(-150.0, 0.0, 0.0), -Vec3::UnitX()};
  for (const Vec3& axis : {Vec3(1.0, 0.0, 0.0), Vec3(0.8, 0.6, 0.0), Vec3(0.0, 0.6, -0.8)}) {
    const GunPose to = {150.0 * axis, axis};
    const auto poses = ways.between(from, to);
    ASSERT_TRUE(poses);
    EXPECT_FALSE(poses->empty());
    EXPECT_GE(nearest(from, *poses, to, over), 25.0);
    // The gun faces the ball everywhere.
    for (const GunPose& pose : *poses) {
      EXPECT_GT(pose.axis.dot(pose.place.normalized()), 0.9);
    }
  }
  EXPECT_DOUBLE_EQ(ways.nearestOn(from.place, -from.place), 0.0);
}

TEST(ClearWays, DoNotGoBelow) {
  const Walls walls = Walls::of(ball(100.0));
  const GunPose from = {Vec3(-150.0, 0.0, 0.0), -Vec3::UnitX()};
  const GunPose to = {Vec3(150.0, 0.0, 0.0), Vec3::UnitX()};
  for (const Vec3& upper : {Vec3(0.0, 0.0, 1.0), Vec3(0.0, 0.0, -1.0), Vec3(0.0, 0.6, 0.8)}) {
    const auto poses = ClearWays(walls, 25.0, true, upper).between(from, to);
    ASSERT_TRUE(poses);
    for (const GunPose& pose : *poses) {
      EXPECT_GE(upper.dot(pose.place), -1e-9);
    }
  }
}

TEST(ClearWays, GoStraightWhereItIsClear) {
  const Walls walls = Walls::of(ball(100.0));
  const Vec3 aside = Vec3(-1.0, 0.2, 0.0).normalized();
  const auto poses = ClearWays(walls, 25.0)
                         .between({Vec3(-150.0, 0.0, 0.0), -Vec3::UnitX()}, {150.0 * aside, aside});
  ASSERT_TRUE(poses);
  EXPECT_TRUE(poses->empty());
}

TEST(ClearWays, LeaveTheInsideOfARing) {
  // 200 and 50 about: the axis of the inmost place meets the other side of the ring.
  const Walls walls = Walls::of(ring(200.0, 50.0));
  const auto over = [](const Vec3& p) {
    return std::hypot(std::hypot(p.x(), p.y()) - 200.0, p.z()) - 50.0;
  };
  const GunPose inside = {Vec3(110.0, 0.0, 0.0), -Vec3::UnitX()};
  const GunPose outside = {Vec3(290.0, 0.0, 0.0), Vec3::UnitX()};
  const GunPose beyond = {Vec3(-290.0, 0.0, 0.0), -Vec3::UnitX()};
  for (const GunPose& to : {outside, beyond}) {
    const auto poses = ClearWays(walls, 20.0).between(inside, to);
    ASSERT_TRUE(poses);
    EXPECT_FALSE(poses->empty());
    EXPECT_GE(nearest(inside, *poses, to, over), 20.0);
  }
  const GunPose across = {Vec3(-110.0, 0.0, 0.0), Vec3::UnitX()};
  const auto straight = ClearWays(walls, 20.0).between(inside, across);
  ASSERT_TRUE(straight);
  EXPECT_TRUE(straight->empty());
}

TEST(ClearWays, LiftFirstWhereLinesLieNearerThanTheClearance) {
  // The ends are 10 off a box, the way between 30: off along the axis, along, and back.
  const Walls walls(box(400.0));
  const GunPose from = {Vec3(200.0, 350.0, 410.0), Vec3::UnitZ()};
  const GunPose to = {Vec3(200.0, 50.0, 410.0), Vec3::UnitZ()};
  const auto poses = ClearWays(walls, 30.0).between(from, to);
  ASSERT_TRUE(poses);
  ASSERT_GE(poses->size(), 2U);
  EXPECT_GE(poses->front().place.z(), 430.0);
  EXPECT_NEAR((poses->front().place - from.place).head<2>().norm(), 0.0, 1e-12);
  EXPECT_GE(poses->back().place.z(), 430.0);
  EXPECT_NEAR((poses->back().place - to.place).head<2>().norm(), 0.0, 1e-12);
}

TEST(ClearWays, FindNoneWhereTheHollowIsTooSmall) {
  const Walls walls = Walls::of(ball(100.0));
  const GunPose from = {Vec3(-80.0, 0.0, 0.0), Vec3::UnitX()};
  const GunPose to = {Vec3(0.0, 80.0, 0.0), -Vec3::UnitY()};
  EXPECT_TRUE(ClearWays(walls, 50.0).between(from, to));
  EXPECT_FALSE(ClearWays(walls, 120.0).between(from, to));
}

}  // namespace
}  // namespace arelem::spray
