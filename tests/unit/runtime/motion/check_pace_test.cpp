#include "runtime/motion/check_pace.h"

#include <random>

#include <gtest/gtest.h>

#include "runtime/motion/field.h"

namespace {
using namespace arelem;
using motion::CheckPace;

struct Dice {
  std::mt19937 engine{1};
  double real(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine);
  }
  Vec3 place(double size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
};

std::vector<surface::AnySurface> surfaces(Dice& dice) {
  const Vec3 axis = dice.place(1.0).normalized();
  const double half = dice.real(0.1, 1.4);
  const double a = dice.real(0.2, 1.0), b = dice.real(0.0, 1.0);
  return {surface::Plane{axis, dice.real(-5.0, 5.0)},
          surface::Sphere{dice.place(3.0), dice.real(0.5, 8.0)},
          surface::Cylinder{dice.place(3.0), axis, dice.real(0.5, 8.0)},
          surface::Cone{dice.place(3.0), axis, std::cos(half), std::sin(half)},
          surface::Quadric(Eigen::Vector3d(a, b, 0.5).asDiagonal(), dice.place(0.3), -9.0)};
}

/// Steps of the gap over its closing rate never pass a zero.
TEST(CheckPace, StepsEndBeforeTheSurface) {
  constexpr double deep = 1.0;
  Dice dice;
  for (int trial = 0; trial < 300; ++trial) {
    const auto cutter = *tool::makeProfile(std::vector{dice.real(0.5, 6.0), 0.25});
    for (const auto& s : surfaces(dice)) {
      const CheckPace pace(s, &cutter);
      const Vec3 from = dice.place(12.0);
      Vec3 way = dice.place(1.0).normalized();
      if (const auto* cone = std::get_if<surface::Cone>(&s); cone != nullptr && trial % 3 == 0) {
        way = cone->cosHalf * cone->axis + cone->sinHalf * cone->axis.unitOrthogonal();
      }
      const Vec3 axis = dice.place(1.0).normalized();
      for (const double side : {1.0, -1.0}) {
        const auto field = motion::makeField(s, side, {&cutter, 0.0});
        const auto here = field->at(from, axis);
        const double rate = pace.closing(side, here.gap, here.normal.dot(way), way);
        const double reach = std::min(std::abs(here.gap) / rate, 1e4);
        double last = here.gap, lastAt = 0.0;
        for (const double share : {0.1, 0.3, 0.6, 0.9, 0.999}) {
          const double at = share * reach;
          const double gap = field->at(from + at * way, axis).gap;
          EXPECT_GE(gap * here.gap, -1e-7 * std::abs(here.gap))
              << "kind " << s.index() << " side " << side << " at " << at << " of " << reach;
          // Deep in the surface the contact may jump to another place, that says more.
          if (std::min(gap, last) > -deep) {
            EXPECT_LE(std::abs(gap - last), pace.most(way) * (at - lastAt) + 1e-7)
                << "kind " << s.index() << " side " << side;
          }
          last = gap;
          lastAt = at;
        }
      }
    }
  }
}

/// Along the lines of a cylinder, or of a cone away from its vertex, nothing comes nearer.
TEST(CheckPace, KnowsWaysThatNeverMeet) {
  const CheckPace cylinder(surface::Cylinder{Vec3::Zero(), Vec3::UnitX(), 2.0}, nullptr);
  EXPECT_EQ(cylinder.most(Vec3::UnitX()), 0.0);
  EXPECT_EQ(cylinder.most(Vec3::UnitY()), 1.0);
  const CheckPace cone(surface::Cone{Vec3::Zero(), Vec3::UnitX(), 0.8, 0.6}, nullptr);
  EXPECT_NEAR(cone.closing(1.0, -5.0, 0.0, Vec3(0.8, 0.6, 0.0)), 0.0, 1e-15);
  EXPECT_NEAR(cone.closing(1.0, 5.0, 0.0, Vec3(0.8, 0.6, 0.0)), 0.0, 1e-8);
}
}  // namespace
