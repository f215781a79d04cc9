#include <cmath>

#include <gtest/gtest.h>

#include "runtime/tool/contact.h"

// Tools whose axis goes through the axis of a cylinder or the center of a sphere (TLAXIS/NORMPS),
// in all positions: what is left of the offset across the axis is rounding there.
namespace arelem::tool {
namespace {

constexpr double radius = 15.0, halfWidth = 5.0, lift = 1.0;

/// A flat cutter of diameter 10 that stands in a hollow of radius 15, its end 14 from the center:
/// the rim is sqrt(14^2 + 5^2) from there.
template <class S>
void expectRim(const S& hollow, const Vec3& center, const Vec3& axis) {
  const Profile flat = *makeProfile(std::vector{2.0 * halfWidth});
  const Vec3 end = center - (radius - lift) * axis;
  Search<S> search;
  const Contact c = contact(hollow, -1.0, flat, end, axis, search);
  const double distance = std::hypot(radius - lift, halfWidth);
  EXPECT_NEAR(c.gap, radius - distance, 1e-12);
  EXPECT_NEAR(c.normal.norm(), 1.0, 1e-12);
  EXPECT_NEAR(c.normal.dot(axis), (radius - lift) / distance, 1e-12);
  EXPECT_NEAR((c.point - end).norm(), halfWidth, 1e-12);
  EXPECT_NEAR((c.point - end).dot(axis), 0.0, 1e-12);
}

TEST(AxisThroughCenter, TouchesHollowsWithTheRim) {
  for (int i = 0; i < 200; ++i) {
    const Vec3 turn(std::sin(1.0 + i), std::cos(2.0 * i), std::sin(3.0 * i));
    const Eigen::AngleAxisd rotation(0.1 * i, turn.normalized());
    const Vec3 axis = rotation * Vec3(Vec3::UnitZ());
    const Vec3 center = rotation * Vec3(0.3 * i, -7.0, 0.1 * i);
    surface::Cylinder cylinder;
    cylinder.point = center;
    cylinder.axis = rotation * Vec3(Vec3::UnitX());
    cylinder.radius = radius;
    expectRim(cylinder, center, axis);
    expectRim(surface::Sphere{center, radius}, center, axis);
  }
}

/// A ring whose axis goes through that of the cone but for rounding: what the distance there leaves
/// square to the axis is rounding too.
TEST(AxisThroughCenter, RingsKeepToTheirCircle) {
  surface::Cone cone;
  cone.vertex = {-30.55746736708699, -5.454703895588316, -4.549072265625};
  cone.axis = {0.9950331994381186, -0.0995436186600694, 0.0};
  constexpr double half = 8.462890625 * 3.14159265358979323846 / 180.0;
  cone.cosHalf = std::cos(half);
  cone.sinHalf = std::sin(half);
  const Profile ring = makeRing(0.1064453125, 0.4083251953125);
  const Vec3 end(-10.220509362628839, -7.4794606072528618, -1.9192171095953474);
  const Vec3 upright(-0.14607416424361455, 0.018285156106005625, 0.98910464138366494);
  for (const double lean : {0.0, 1e-16, 3e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 aside(std::sin(1.0 + i), std::cos(2.0 * i), std::sin(3.0 * i));
      const Vec3 axis = (upright + lean * aside).normalized();
      Search<surface::Cone> search;
      const Contact c = contact(cone, 1.0, ring, end, axis, search);
      const Vec3 w = c.point - end;
      EXPECT_NEAR(w.dot(axis), ring.f, 1e-12) << "lean " << lean;
      EXPECT_NEAR((w - w.dot(axis) * axis).norm(), ring.e, 1e-12) << "lean " << lean;
      EXPECT_NEAR(c.gap, 0.0018, 1e-9 + lean);
    }
  }
}

}  // namespace
}  // namespace arelem::tool
