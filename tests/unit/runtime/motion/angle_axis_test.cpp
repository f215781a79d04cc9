#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/motion/axis_source.h"

namespace arelem::motion {
namespace {

// A level bottom on a sphere: with every axis that leans by the angle its own normal is the axis.
// The one to choose is in the plane of the drive normal and the place.
TEST(AngleAxis, OfALevelBottomOnABulgeFollowsFromThePlaceAlone) {
  const auto cutter = tool::makeProfile(std::array<double, 7>{2, 0, 1, 0, 0, 0, 4});
  ASSERT_TRUE(cutter);
  const surface::AnySurface drive = surface::Plane{Vec3::UnitY(), 0.0};
  const surface::AnySurface part = surface::Sphere{Vec3::Zero(), 10.0};
  Tilt tilt;
  tilt.alpha = 80.0 * std::numbers::pi / 180.0;
  const auto side = [&](const surface::AnySurface& surface, const char* name) {
    return AngleSide{makeField(surface, 1.0, Tool{&*cutter}), false, name, 1.0,
                     makeField(surface, 1.0, {})};
  };
  const Vec3 place(0.2, 1.7, 9.85);
  const Vec3 along = Vec3(place.x(), 0.0, place.z()).normalized();
  const Vec3 expected = std::cos(tilt.alpha) * Vec3::UnitY() + std::sin(tilt.alpha) * along;
  for (const Vec3& start :
       {Vec3(0, 0, 1), Vec3(0.05, 0.17, 0.98), Vec3(-0.05, 0.2, 1), Vec3(0.02, 0.17, 1)}) {
    const auto axis =
        atAngle(tilt, side(drive, "DS"), side(part, "PS"), start.normalized(), Vec3::Zero());
    EXPECT_LT((axis->at(place) - expected).norm(), 1e-12) << start.transpose();
    EXPECT_FALSE(axis->fault());
  }
}

}  // namespace
}  // namespace arelem::motion
