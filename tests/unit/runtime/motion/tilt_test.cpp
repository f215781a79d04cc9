#include "runtime/motion/tilt.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace arelem::motion {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Part normal z, drive normal y, motion along x.
std::optional<Vec3> axisAt(double alpha, std::optional<double> lead = {}) {
  Tilt tilt;
  tilt.alpha = alpha * degree;
  if (lead) {
    tilt.lead = *lead * degree;
  }
  return tilted(tilt, Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX());
}

void expectAxis(const std::optional<Vec3>& axis, const Vec3& expected) {
  ASSERT_TRUE(axis);
  EXPECT_LT((*axis - expected).norm(), 1e-14) << axis->transpose();
}

TEST(Tilt, AlphaLeansTowardsTheOtherNormal) {
  expectAxis(axisAt(0), {0, 0, 1});
  expectAxis(axisAt(30), {0, 0.5, std::sqrt(0.75)});
  expectAxis(axisAt(-30), {0, -0.5, std::sqrt(0.75)});
}

TEST(Tilt, LeadLeansIntoTheMotion) {
  // cos 60 up, sin 30 ahead, the rest across: 1/2, 1/2 and the root of 1/2.
  expectAxis(axisAt(60, 30), {0.5, std::sqrt(0.5), 0.5});
  expectAxis(axisAt(60, -30), {-0.5, std::sqrt(0.5), 0.5});
  expectAxis(axisAt(-60, 30), {0.5, -std::sqrt(0.5), 0.5});
}

TEST(Tilt, MoreLeadThanAlphaLeavesNoAxis) {
  expectAxis(axisAt(20, 20), {std::sin(20 * degree), 0, std::cos(20 * degree)});
  EXPECT_FALSE(axisAt(20, 21));
}

TEST(Tilt, FourAxesStaySquareToTheVector) {
  Tilt tilt;
  tilt.alpha = 30 * degree;
  tilt.across = Vec3(Vec3::UnitX());
  expectAxis(tilted(tilt, Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()), {0, 0.5, std::sqrt(0.75)});
  // The plane square to y holds the motion: alpha leads.
  tilt.across = Vec3(Vec3::UnitY());
  expectAxis(tilted(tilt, Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()), {0.5, 0, std::sqrt(0.75)});
  // A normal at 45 degrees to that plane: no axis at 30 degrees from it, one at 45.
  const Vec3 slanting = Vec3(0, 1, 1).normalized();
  EXPECT_FALSE(tilted(tilt, slanting, Vec3::UnitY(), Vec3::UnitX()));
  tilt.alpha = 45 * degree;
  expectAxis(tilted(tilt, slanting, Vec3(0, 1, -1).normalized(), Vec3::UnitX()), {0, 0, 1});
}

TEST(Tilt, FourAxesKeepTheirSense) {
  Tilt tilt;
  tilt.alpha = 30 * degree;
  tilt.across = Vec3(Vec3::UnitX());
  const auto axis = tilted(tilt, Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX());
  ASSERT_TRUE(axis);
  tilt.turn = turnAbout(*tilt.across, Vec3::UnitZ(), *axis);
  EXPECT_EQ(tilt.turn, -1.0);
  expectAxis(tilted(tilt, Vec3::UnitZ(), -Vec3::UnitY(), Vec3::UnitX()), *axis);
  EXPECT_EQ(turnAbout(*tilt.across, Vec3::UnitZ(), Vec3::UnitZ()), 0.0);
}

TEST(Tilt, ParallelNormalsLeaveNoAxis) {
  Tilt tilt;
  tilt.alpha = 30 * degree;
  EXPECT_FALSE(tilted(tilt, Vec3::UnitZ(), -Vec3::UnitZ(), Vec3::UnitX()));
}

}  // namespace
}  // namespace arelem::motion
