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

}  // namespace
}  // namespace arelem::tool
