#include "runtime/tool/section_contact.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "runtime/tool/contact.h"

// Cutters across tabulated cylinders: the section along the generatrix tells all.
namespace arelem::tool {
namespace {

using surface::TabulatedCylinder;

/// z = first (4x - x^2) over x in [0, 4], then z = second (4t - t^2) with t = x - 4, with straight
/// ends; the generatrix is y. Up is its positive side.
TabulatedCylinder waves(double first, double second) {
  auto curve = std::make_shared<TabulatedCylinder::Curve>();
  curve->u = Vec3::UnitX();
  curve->v = Vec3::UnitZ();
  curve->w = -Vec3::UnitY();
  const auto arch = [](double from, double k) {
    TabulatedCylinder::Piece p{};
    p.u = from;
    p.dirU = 1.0;
    p.length = 4.0;
    p.b = -k;
    p.c = 4.0 * k;
    p.lowY = std::min(0.0, 4.0 * k);
    p.highY = std::max(0.0, 4.0 * k);
    return p;
  };
  TabulatedCylinder::Piece before{}, behind{};
  before.dirU = behind.dirU = 1.0 / std::hypot(1.0, 4.0 * first);
  before.dirV = 4.0 * first * before.dirU;
  behind.dirV = -4.0 * second / std::hypot(1.0, 4.0 * second);
  behind.dirU = 1.0 / std::hypot(1.0, 4.0 * second);
  before.length = behind.length = 40.0;
  before.u = -40.0 * before.dirU;
  before.v = -40.0 * before.dirV;
  before.openStart = behind.openEnd = true;
  behind.u = 8.0;
  curve->pieces = {before, arch(0.0, first), arch(4.0, second), behind};
  return TabulatedCylinder(std::move(curve));
}

Profile cutter(const std::vector<double>& values) {
  return *makeProfile(values);
}

/// Places of the section of a cutter, `x` across and `z` along the axis.
std::vector<Eigen::Vector2d> outline(const Profile& p, int count) {
  std::vector<Eigen::Vector2d> places;
  const auto add = [&](double rho, double z) {
    places.emplace_back(rho, z);
    places.emplace_back(-rho, z);
  };
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    add(s * p.bottomEnd.rho, s * p.bottomEnd.z);
    add(p.sideStart.rho + s * (p.sideEnd.rho - p.sideStart.rho),
        p.sideStart.z + s * (p.sideEnd.z - p.sideStart.z));
    const double angle = p.alpha + s * (M_PI / 2 - p.beta - p.alpha);
    add(p.e + p.r * std::sin(angle), p.f - p.r * std::cos(angle));
  }
  return places;
}

TEST(SectionContact, AFlatCutterOverATroughStandsOnBothRims) {
  // z = x^2/4 - x has its lowest place, -1, at x = 2; at 1 and 3 it is -3/4.
  const TabulatedCylinder trough = waves(-0.25, 0.25);
  const Profile flat = cutter({2.0});
  Search<TabulatedCylinder> search;
  Contact c = contact(trough, 1.0, flat, {2.0, 5.0, -0.75}, Vec3::UnitZ(), search);
  EXPECT_NEAR(c.gap, 0.0, 1e-14);
  EXPECT_NEAR(std::abs(c.point.x() - 2.0), 1.0, 1e-14);
  EXPECT_NEAR(c.normal.x() / c.normal.z(), c.point.x() > 2.0 ? -0.5 : 0.5, 1e-14);
  // Moved aside it stands on one: at x = 3.5 the trough is -7/16.
  c = contact(trough, 1.0, flat, {2.5, 5.0, -0.4375}, Vec3::UnitZ(), search);
  EXPECT_NEAR(c.gap, 0.0, 1e-14);
  EXPECT_NEAR(c.point.x(), 3.5, 1e-14);
}

TEST(SectionContact, AFlatCutterOverACrestStandsOnItsBottom) {
  const TabulatedCylinder crest = waves(0.25, -0.25);
  Search<TabulatedCylinder> search;
  const Contact c = contact(crest, 1.0, cutter({2.0}), {2.3, 0, 1.125}, Vec3::UnitZ(), search);
  EXPECT_NEAR(c.gap, 0.125, 1e-14);
  EXPECT_NEAR((c.normal - Vec3::UnitZ()).norm(), 0.0, 1e-14);
  EXPECT_NEAR((c.point - Vec3(2.0, 0, 1.125)).norm(), 0.0, 1e-14);
}

TEST(SectionContact, IsTheLeastOfAllPlacesOfTheCutterWhateverCameBefore) {
  const std::vector<std::vector<double>> cutters = {{0.75},
                                                    {0.75, 0.375},
                                                    {1.0, 0.1875},
                                                    {0.75, 0.125, 0.266342, 0.125, 0, 8, 3},
                                                    {1.0, 0, 0.5, 0, 0, 0, 2},
                                                    {3.0, 0.4, 1.1, 0.4, 0, 0, 6},
                                                    {1.0, 0, 0, 0, 20, 0, 4}};
  std::mt19937_64 engine(11);
  const auto in = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  };
  for (const double side : {1.0, -1.0}) {
    const TabulatedCylinder s = waves(side * in(0.2, 0.5), side * in(-0.5, -0.2));
    for (const auto& values : cutters) {
      const Profile p = cutter(values);
      const auto places = outline(p, 400);
      const double lean = in(-0.3, 0.3);
      const Vec3 axis = side * Vec3(std::sin(lean), 0, std::cos(lean));
      const Vec3 across(axis.z(), 0, -axis.x());
      Search<TabulatedCylinder> search;
      for (int i = 0; i < 200; ++i) {
        const Vec3 te(in(-2, 10), in(-3, 3), side * in(-1, 4));
        const Contact c = contact(s, side, p, te, axis, search);
        if (c.gap < -0.02) {
          continue;  // deep gouges have no single contact
        }
        TabulatedCylinder::Hint hint{};
        double least = 1e9;
        for (const auto& q : places) {
          least = std::min(least, side * s.foot(te + q.x() * across + q.y() * axis, hint).distance);
        }
        EXPECT_LE(c.gap, least + 1e-9);
        EXPECT_NEAR(c.gap, least, 1e-4);
        EXPECT_NEAR(side * s.foot(c.point, hint).distance, c.gap, 1e-9);
        Search<TabulatedCylinder> fresh;
        EXPECT_NEAR(contact(s, side, p, te, axis, fresh).gap, c.gap, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace arelem::tool
