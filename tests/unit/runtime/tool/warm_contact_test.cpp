#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "runtime/tool/contact.h"

// A contact that is foretold by the last one is the contact that a search from nothing finds: along
// ways over the crests of surfaces, with steps as long as cut vectors are.
namespace arelem::tool {
namespace {

Profile cutter(std::initializer_list<double> values) {
  return *makeProfile(std::span<const double>(values.begin(), values.size()));
}

/// Over the top of the surface from x = -30 to 30, the tool end near `height` and `aside` in y.
template <surface::Surface S>
void walk(const S& s, const Profile& c, double height, double aside) {
  Search<S> warm;
  for (int i = 0; i <= 120; ++i) {
    const double x = -30.0 + 0.5 * i;
    const Vec3 te(x, aside + 0.1 * std::sin(i), height - 0.004 * x * x);
    const Contact foretold = contact(s, 1.0, c, te, Vec3::UnitZ(), warm);
    Search<S> cold;
    const Contact searched = contact(s, 1.0, c, te, Vec3::UnitZ(), cold);
    ASSERT_NEAR(foretold.gap, searched.gap, 1e-9) << "x " << x;
    ASSERT_NEAR(foretold.normal.norm(), 1.0, 1e-12) << "x " << x;
    // The gap is the distance of the place that touches, whichever of several it is.
    typename S::Hint hint{};
    ASSERT_NEAR(s.foot(foretold.point, hint).distance, foretold.gap, 1e-9) << "x " << x;
    ASSERT_NEAR((foretold.normal - searched.normal).norm(), 0.0, 1e-6) << "x " << x;
  }
}

class WarmContact : public ::testing::TestWithParam<int> {
 protected:
  static Profile tool() {
    const std::array all{cutter({12.0, 6.0}), cutter({12.0, 0.0}), cutter({12.0, 1.5}),
                         cutter({12.0, 1.0, 4.0, 1.0, 0.0, 10.0, 30.0})};
    return all[static_cast<std::size_t>(GetParam())];
  }
};

TEST_P(WarmContact, OnACylinder) {
  walk(surface::Cylinder{{0.0, 0.0, -60.0}, Vec3::UnitY(), 80.0}, tool(), 20.5, 0.0);
  walk(surface::Cylinder{{0.0, 0.0, -60.0}, Vec3(0.1, 1.0, 0.2).normalized(), 80.0}, tool(), 22.5,
       3.0);
}

TEST_P(WarmContact, OnACone) {
  const double half = std::numbers::pi / 12.0;
  walk(surface::Cone{{0.0, -300.0, -60.0}, Vec3::UnitY(), std::cos(half), std::sin(half)}, tool(),
       25.0, 2.0);
}

/// Around a cone, past its tip and over it, with the tool axis upright to leaning by a right angle.
TEST_P(WarmContact, AroundACone) {
  const double half = std::numbers::pi / 7.0;
  const surface::Cone s{
      {1.0, 2.0, 3.0}, Vec3(0.3, -0.2, -0.9).normalized(), std::cos(half), std::sin(half)};
  for (int k = 0; k < 4; ++k) {
    const Vec3 axis = Vec3(0.5 * k, 0.2, 1.5 - 0.5 * k).normalized();
    for (const double radius : {25.0, 12.0, 4.0, 0.5}) {
      Search<surface::Cone> warm;
      for (int i = 0; i <= 150; ++i) {
        const double angle = 0.05 * i;
        const Vec3 te =
            s.vertex + Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.2 * i - 15.0);
        const Contact foretold = contact(s, 1.0, tool(), te, axis, warm);
        Search<surface::Cone> cold;
        const Contact searched = contact(s, 1.0, tool(), te, axis, cold);
        if (searched.gap > 0.0) {
          ASSERT_NEAR(foretold.gap, searched.gap, 1e-9) << k << " " << radius << " " << i;
          ASSERT_NEAR((foretold.normal - searched.normal).norm(), 0.0, 1e-6) << i;
          ASSERT_NEAR((foretold.point - searched.point).norm(), 0.0, 1e-4) << i;
        }
      }
    }
  }
}

TEST_P(WarmContact, OnATorus) {
  walk(surface::Torus{{0.0, 0.0, -100.0}, Vec3::UnitY(), 100.0, 30.0}, tool(), 31.0, 4.0);
}

TEST_P(WarmContact, OnAQuadric) {
  const Eigen::Matrix3d matrix = Vec3(0.0002, 0.0003, 0.00025).asDiagonal();
  walk(surface::Quadric(matrix, Vec3::Zero(), -1.0), tool(), 64.0, 7.0);
}

INSTANTIATE_TEST_SUITE_P(Cutters, WarmContact, ::testing::Range(0, 4));

/// The bottom over the crest of a cylinder touches along a line: the gap is the height over it, as
/// long as any of the bottom is above the crest.
TEST(WarmContact, BottomOverACrestIsAtItsHeight) {
  const surface::Cylinder s{{0.0, 0.0, -60.0}, Vec3::UnitY(), 80.0};
  const Profile flat = cutter({12.0, 0.0});
  Search<surface::Cylinder> warm;
  for (int i = -11; i <= 11; ++i) {
    const Contact c = contact(s, 1.0, flat, {0.5 * i, 0.0, 21.0}, Vec3::UnitZ(), warm);
    EXPECT_NEAR(c.gap, 1.0, 1e-12) << i;
    EXPECT_NEAR((c.normal - Vec3::UnitZ()).norm(), 0.0, 1e-9) << i;
    EXPECT_NEAR(c.point.x(), 0.0, 1e-6) << i;
  }
}

/// A ball with its shank along the wall of a hollow cylinder that leans: within a ten-thousandth of
/// the way the contact goes over from the ball to the rim of the shank, between two directions at
/// which a survey looks.
TEST(WarmContact, InAHollowGoesOverToTheRim) {
  const Vec3 along(-0.0705045733896139, 0.9975114561403035, 0.06889648437500001);
  const surface::Cylinder s{{0.0, 0.0, 8.62109375}, along.normalized(), 8.9375};
  const Profile ball = cutter({0.5, 0.25, 0.0, 0.25, 0.0, 0.0, 5.0});
  const Vec3 from(-4.626898089325902, -53.152890544780661, 2.3825212514188898);
  const Vec3 to(-4.6269474991116404, -53.153041367987477, 2.3827246493257741);
  Search<surface::Cylinder> warm;
  bool onRim = false;
  for (int i = 0; i <= 40; ++i) {
    const Vec3 te = from + i / 40.0 * (to - from);
    const Contact foretold = contact(s, -1.0, ball, te, Vec3::UnitZ(), warm);
    Search<surface::Cylinder> cold;
    const Contact searched = contact(s, -1.0, ball, te, Vec3::UnitZ(), cold);
    ASSERT_NEAR(foretold.gap, searched.gap, 1e-9) << i;
    onRim = onRim || searched.point.z() - te.z() > 4.999;
  }
  EXPECT_TRUE(onRim);
}

/// The upper rim between the sheet that falls and the one that rises: the places where it is near
/// to both are less than two places of a survey apart.
TEST(WarmContact, NearPlacesNextToEachOtherOnTheRim) {
  const auto section = [](double y, double z, double radius) {
    geometry::SectionCurve curve;
    curve.surface.type = EntityType::cylinder;
    curve.surface.canon = {0, y, z, 0, 0, 1, radius};
    curve.start = {-4.5, -2.394, z};
    curve.finish = {4.5, -2.394, z};
    curve.heading = Vec3::UnitY();
    return curve;
  };
  const surface::Ruled s({section(-6.124, -4.0, 5.73), section(-7.507, 4.0, 7.113)});
  const double corner = 0.397;
  const Profile bull = cutter({1.5, corner, 0.75 - corner, corner, 0.0, 0.0, 5.0});
  const Vec3 te(5.10666, -0.75674, 7.648);
  surface::Ruled::Hint hint{};
  double least = 1.0;
  for (int k = 0; k < 3600; ++k) {
    const double angle = k * std::numbers::pi / 1800.0;
    const Vec3 onRim(0.75 * std::cos(angle), 0.75 * std::sin(angle), 5.0);
    least = std::min(least, -s.foot(te + onRim, hint).distance);
  }
  Search<surface::Ruled> search;
  EXPECT_NEAR(contact(s, -1.0, bull, te, Vec3::UnitZ(), search).gap, least, 1e-6);
}

}  // namespace
}  // namespace arelem::tool
