#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "runtime/geometry/kinds.h"

// RLDSRF against forms of the same surface that a pencil gives.
namespace arelem::surface {
namespace {

using geometry::SectionCurve;

SectionCurve onPlane(const Vec3& normal, double offset, const Vec3& from, const Vec3& to) {
  SectionCurve curve;
  curve.surface.type = EntityType::plane;
  curve.surface.canon = {normal.x(), normal.y(), normal.z(), offset};
  curve.start = from;
  curve.finish = to;
  return curve;
}

/// The rulings from (x, -1, -x) to (x, 1, x) are the saddle z = x y.
Ruled saddle() {
  const double c = std::sqrt(0.5);
  return Ruled({onPlane({c, 0, c}, 0, {-1, -1, 0}, {1, -1, 0}),
                onPlane({-c, 0, c}, 0, {-1, 1, 0}, {1, 1, 0})});
}

TEST(Ruled, TwoCrossingLinesMakeASaddle) {
  const Ruled s = saddle();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> in(-1.2, 1.2), off(-0.3, 0.3);
  for (int i = 0; i < 300; ++i) {
    const double x = in(random), y = in(random), d = off(random);
    const Vec3 normal = Vec3(-y, -x, 1).normalized();
    const Vec3 place(x, y, x * y);
    Ruled::Hint hint{};
    const Vec3 p = place + d * normal;
    const Foot foot = s.foot(p, hint);
    const double sense = foot.normal.dot(normal);
    ASSERT_NEAR(std::abs(sense), 1.0, 1e-9) << i;
    EXPECT_NEAR(foot.distance * sense, d, 1e-11) << i;
  }
}

TEST(Ruled, SaddleBendsAlongItsDiagonals) {
  // At the origin z = x y has the principal curvatures 1 and -1 along y = x and y = -x.
  const Ruled s = saddle();
  Ruled::Hint hint{};
  const Foot foot = s.foot({0, 0, 0}, hint);
  const double sense = foot.normal.z();
  const double c = std::sqrt(0.5);
  EXPECT_NEAR(s.bend({0, 0, 0}, foot, Vec3(c, c, 0), hint) * sense, -1.0, 1e-12);
  EXPECT_NEAR(s.bend({0, 0, 0}, foot, Vec3(c, -c, 0), hint) * sense, 1.0, 1e-12);
  EXPECT_NEAR(s.bend({0, 0, 0}, foot, Vec3(1, 0, 0), hint), 0.0, 1e-12);
}

/// Of the cylinder of radius 12 along y, 10 below it.
SectionCurve cylinderArc(double y) {
  SectionCurve curve;
  curve.surface.type = EntityType::cylinder;
  curve.surface.canon = {0, 0, -10, 0, 1, 0, 12};
  curve.start = {-4, y, 0};
  curve.finish = {4, y, 0};
  return curve;
}

TEST(Ruled, EqualSectionsOfACylinderAreTheCylinder) {
  const Ruled s({cylinderArc(-3), cylinderArc(3)});
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> angle(-0.6, 0.6), height(-5, 5), off(-2, 2);
  for (int i = 0; i < 300; ++i) {
    const double a = angle(random), d = off(random);
    const Vec3 normal(std::sin(a), 0, std::cos(a));
    const Vec3 p = Vec3(0, height(random), -10) + (12 + d) * normal;
    Ruled::Hint hint{};
    const Foot foot = s.foot(p, hint);
    const double sense = foot.normal.dot(normal);
    ASSERT_NEAR(std::abs(sense), 1.0, 1e-9) << i;
    EXPECT_NEAR(foot.distance * sense, d, 1e-10) << i;
    const Vec3 across(std::cos(a), 0, -std::sin(a));
    EXPECT_NEAR(s.bend(p, foot, across, hint) * sense, 1.0 / (12 + d), 1e-9);
    EXPECT_NEAR(s.bend(p, foot, Vec3::UnitY(), hint), 0.0, 1e-12);
  }
}

TEST(Ruled, TheCylinderBendsOneWayAsMuchAsItsRadiusSays) {
  // Proofs live on how narrow these bounds are: the curvature is 1/12 across and 0 along.
  const Ruled s({cylinderArc(-3), cylinderArc(3)});
  for (const double a : {-0.2, 0.0, 0.15}) {
    for (const double y : {-4.0, 0.0, 3.5}) {
      const Vec3 normal(std::sin(a), 0, std::cos(a));
      const Vec3 on = Vec3(0, y, -10) + 12 * normal;
      Ruled::Hint hint{};
      Foot foot = s.foot(on, hint);
      Bends bends = s.bends(on, foot, 0.5, hint);
      if (foot.normal.dot(normal) < 0.0) {
        bends = {-bends.high, -bends.low};
      }
      EXPECT_GE(bends.low, -1e-6) << a << ' ' << y;
      EXPECT_GE(bends.high, 1.0 / 12) << a << ' ' << y;
      EXPECT_LE(bends.high, 1.05 / (12 - 0.5)) << a << ' ' << y;
    }
  }
}

TEST(Ruled, IsKnownWhereItsCurvesAreSteepAndBeyondThem) {
  // Up to 74 degrees from the top of the cylinder, and on the tangent behind the end.
  SectionCurve arc = cylinderArc(-3);
  arc.start.x() = -12;
  arc.finish.x() = 12;
  SectionCurve other = arc;
  other.start.y() = other.finish.y() = 3;
  arc.start.z() = arc.finish.z() = other.start.z() = other.finish.z() = -10;
  const Ruled s({arc, other});
  for (const double a : {0.0, 1.0, 1.3}) {
    const Vec3 on = Vec3(12 * std::sin(a), 0.5, 12 * std::cos(a) - 10);
    Ruled::Hint hint{};
    const Foot foot = s.foot(on, hint);
    EXPECT_NEAR(foot.distance, 0.0, 1e-9) << a;
    const Bends bends = s.bends(on, foot, 0.05, hint);
    EXPECT_TRUE(std::isfinite(bends.low) && std::isfinite(bends.high)) << a;
  }
  Ruled::Hint hint{};
  const Vec3 beyond(12, 0.5, -20);
  const Foot foot = s.foot(beyond, hint);
  const Bends bends = s.bends(beyond, foot, 0.05, hint);
  EXPECT_TRUE(std::isfinite(bends.low) && std::isfinite(bends.high));
}

TEST(Ruled, AConeFromACircleToAPoint) {
  SectionCurve circle;
  circle.surface.type = EntityType::cylinder;
  circle.surface.canon = {0, 0, 0, 0, 0, 1, 5};
  circle.start = {3, -4, 0};
  circle.finish = {3, 4, 0};
  circle.heading = Vec3::UnitX();
  SectionCurve apex;
  apex.surface.type = EntityType::point;
  apex.start = apex.finish = Vec3(0, 0, 5);
  const Ruled s({circle, apex});
  const double c = std::sqrt(0.5);
  for (const double a : {-0.9, -0.4, 0.0, 0.3, 0.8}) {
    const Vec3 out(c * std::cos(a), c * std::sin(a), c);
    const Vec3 place(4 * std::cos(a), 4 * std::sin(a), 1);
    Ruled::Hint hint{};
    const Foot foot = s.foot(place + 0.7 * out, hint);
    EXPECT_NEAR(std::abs(foot.distance), 0.7, 1e-11);
    EXPECT_NEAR(std::abs(foot.normal.dot(out)), 1.0, 1e-12);
  }
}

TEST(Ruled, GoesOnAlongItsTangentsBehindTheReachOfACurve) {
  // Behind the last place of the cylinder's section a point on the tangent is on the surface.
  const Ruled s = saddle();
  Ruled::Hint hint{};
  EXPECT_NEAR(s.foot({6, 0.5, 3}, hint).distance, 0.0, 1e-9);
}

/// From an arc of radius 5.2 at y = -4 to one of radius 7.6 that leans from y = 4 by a slope.
struct Twisted {
  explicit Twisted(double slope)
      : lean(slope), sheet({arc(-4, 5.2, Vec3::UnitZ()), arc(4, 7.6, Vec3(0, slope, 1))}) {}

  static SectionCurve arc(double y, double radius, const Vec3& towards) {
    SectionCurve curve;
    curve.surface.type = EntityType::cylinder;
    curve.surface.canon = {0, 0, -radius, 0, 1, 0, radius};
    curve.start = {-4.5, y, -2};
    curve.finish = {4.5, y, -2};
    curve.heading = towards.normalized();
    return curve;
  }
  [[nodiscard]] Vec3 at(double f, double g) const {
    const double x = 9 * f - 4.5;
    const double first = std::sqrt(5.2 * 5.2 - x * x) - 5.2;
    const double second = std::sqrt(7.6 * 7.6 - x * x) - 7.6;
    return {x, (1 - g) * -4 + g * (4 + lean * (second + 2)), (1 - g) * first + g * second};
  }

  double lean;
  Ruled sheet;
};

TEST(Ruled, NoPlaceIsNearerThanTheFoot) {
  for (const double slope : {0.0, 0.4}) {
    const Twisted s(slope);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> inF(0.02, 0.98), inG(-4, 5), off(-5, 5), step(-0.2, 0.2);
    Ruled::Hint hint{};
    Vec3 p = Vec3::Zero();
    for (int i = 0; i < 400; ++i) {
      p += Vec3(step(random), step(random), step(random));
      if (i % 8 == 0) {  // else next to the last, with its hint
        p = s.at(inF(random), inG(random)) + Vec3(0, 0, off(random));
        hint = {};
      }
      const double distance = std::abs(s.sheet.foot(p, hint).distance);
      double least = distance;
      for (double f = 0; f <= 1; f += 1.0 / 512) {
        const Vec3 start = s.at(f, 0);
        const Vec3 along = s.at(f, 1) - start;
        const double g = std::clamp((p - start).dot(along) / along.squaredNorm(), -5.0, 6.0);
        least = std::min(least, (p - start - g * along).norm());
      }
      EXPECT_NEAR(least, distance, 1e-9) << slope << ' ' << i;
    }
  }
}

TEST(Ruled, TheFootChangesSidesWhereAnotherPlaceBecomesTheNearest) {
  // Below the axis of the cylinder the flanks are nearest, the left one of places on the left. One
  // that goes across must not stay with the foot that it knows: left and right are the same.
  const Ruled s({cylinderArc(-3), cylinderArc(3)});
  Ruled::Hint hint{};
  std::vector<double> left;
  constexpr int steps = 20;
  for (int i = -steps; i <= steps; ++i) {
    const double x = 0.05 * i;
    const double away = std::abs(s.foot({x, 0.3, -14}, hint).distance);
    if (i < 0) {
      left.push_back(away);
    } else if (i > 0) {
      EXPECT_NEAR(away, left[static_cast<std::size_t>(steps - i)], 1e-9) << x;
    }
  }
}

TEST(Ruled, BoundsHoldFarAlongTheRulings) {
  int bounded = 0;
  for (const double slope : {0.0, 0.4}) {
    const Twisted s(slope);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> inF(0, 1), inG(-5, 6), any(-1, 1);
    for (int i = 0; i < 400; ++i) {
      const Vec3 on = s.at(inF(random), inG(random));
      Ruled::Hint hint{};
      const Foot foot = s.sheet.foot(on, hint);
      const double radius = 0.3 * std::abs(any(random));
      const Bends bends = s.sheet.bends(on, foot, radius, hint);
      bounded += std::isfinite(bends.low) && std::isfinite(bends.high) ? 1 : 0;
      for (int k = 0; k < 20; ++k) {
        const Vec3 away(any(random), any(random), any(random));
        const Vec3 near = on + radius / 2 * away;
        const Vec3 t = Vec3(any(random), any(random), any(random)).normalized();
        Ruled::Hint there = hint;
        const Foot other = s.sheet.foot(near, there);
        const double sense = other.normal.dot(foot.normal) < 0.0 ? -1.0 : 1.0;
        const double bend = sense * s.sheet.bend(near, other, t, there);
        EXPECT_GE(bend, bends.low - 1e-7) << slope << ' ' << i;
        EXPECT_LE(bend, bends.high + 1e-7) << slope << ' ' << i;
      }
    }
  }
  EXPECT_GT(bounded, 500);  // of 800
}

/// Rows beside the curves that are wider than those before them must not look like another flank.
TEST(Ruled, BoundsAreKnownWhereTheRowsOfTheCurvesEnd) {
  SectionCurve curve;  // of z = -0.06 x^2
  curve.surface.type = EntityType::quadric;
  curve.surface.canon = {0.06, 0, 0, 0, 0, 0, 0, 0, 0, 0.5};
  curve.start = {-4.5, -4, -0.06 * 4.5 * 4.5};
  curve.finish = {4.5, -4, -0.06 * 4.5 * 4.5};
  SectionCurve other = curve;  // wider: the rulings spread
  other.start = {-6, 4, -0.06 * 36};
  other.finish = {6, 4, -0.06 * 36};
  const Ruled s({curve, other});
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(4, 7), y(-12, 20);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from(x(random), y(random), -1.5);
    Ruled::Hint hint{};
    const Foot foot = s.foot(from, hint);
    const Vec3 on = from - foot.distance * foot.normal;
    const Bends bends = s.bends(on, s.foot(on, hint), 0.01);
    EXPECT_TRUE(std::isfinite(bends.low) && std::isfinite(bends.high)) << on.transpose();
  }
}

/// Steep arches whose flanks come as near to each other as places on them are asked about, and join
/// farther off.
TEST(Ruled, BoundsHoldBetweenFlanksThatJoinFartherOff) {
  std::mt19937_64 random(1);
  const auto in = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto any = [&]() -> Vec3 { return Vec3(in(-1, 1), in(-1, 1), in(-1, 1)) / std::sqrt(3.0); };
  int bounded = 0;
  for (int i = 0; i < 60; ++i) {
    const double half = in(0.5, 2);
    const double sharp = in(1, 3.9) / half;
    SectionCurve curve;  // of z = -sharp x^2
    curve.surface.type = EntityType::quadric;
    curve.surface.canon = {sharp, 0, 0, 0, 0, 0, 0, 0, 0, 0.5};
    curve.start = {-half, -3, -sharp * half * half};
    curve.finish = {half, -3, -sharp * half * half};
    SectionCurve other = curve;
    other.start.y() = other.finish.y() = 3;
    const Ruled s({curve, other});
    for (int j = 0; j < 20; ++j) {
      const double x = half * in(-2, 2);
      const Vec3 p = Vec3(x, in(-6, 6), -sharp * x * x) + in(0, 1.5) * any();
      const double radius = in(0.02, 1.5);
      Ruled::Hint hint{};
      const Bends bends = s.bends(p, s.foot(p, hint), radius);
      bounded += std::isfinite(bends.low) || std::isfinite(bends.high) ? 1 : 0;
      for (int k = 0; k < 60; ++k) {
        // Also straight across, where the nearest place changes flanks.
        const bool across = k % 2 == 0;
        const Vec3 u = p + radius * (across ? Vec3(in(-1, 1), 0, 0) : any());
        const Vec3 v = p + radius * (across ? Vec3(in(-1, 1), 0, 0) : any());
        Ruled::Hint h1{}, h2{}, h3{};
        const double squared = (v - u).squaredNorm();
        const double dip = 0.5 * (s.foot(u, h1).distance + s.foot(v, h2).distance) -
                           s.foot(0.5 * (u + v), h3).distance;
        ASSERT_LE(dip, bends.high * squared / 8 + 1e-9) << i << ' ' << j;
        ASSERT_GE(dip, bends.low * squared / 8 - 1e-9) << i << ' ' << j;
      }
    }
  }
  EXPECT_GT(bounded, 500);  // of 1200
}

}  // namespace
}  // namespace arelem::surface
