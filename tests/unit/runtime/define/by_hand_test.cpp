// Definitions whose results a person can check with a pencil, where the old system's programs have
// none.
#include <cmath>

#include "runtime/geometry/ruled_surface.h"
#include "runtime/geometry/tabulated_cylinder.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

const double r2 = std::sqrt(2.0);

TEST(ByHand, TangentPositionsHaveOnePoint) {
  const EntityPtr unit = definedPtr(T::circle, {0.0, 0.0, 1.0});
  const EntityPtr top = definedPtr(T::line, {0.0, 1.0, 1.0, 1.0});
  expectCanon(defined(T::point, {W::XLARGE, W::INTOF, top, unit}).canon, {0, 1, 0}, 1e-15);
  const EntityPtr beside = definedPtr(T::circle, {3.0, 0.0, 2.0});
  expectCanon(defined(T::point, {W::YLARGE, W::INTOF, unit, beside}).canon, {1, 0, 0}, 1e-15);
}

TEST(ByHand, AnglesOfQuarterTurnsAreExact) {
  EXPECT_EQ(defined(T::line, {point(0, 0), W::ATANGL, 90.0}).canon,
            (std::vector<double>{-1, 0, 0, 0}));
  EXPECT_EQ(defined(T::point, {W::RTHETA, W::XYPLAN, 2.0, 30.0}).canon[1], 1.0);
  EXPECT_EQ(defined(T::matrix, {W::XYROT, 270.0}).canon,
            (std::vector<double>{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0}));
}

TEST(ByHand, ALineServesAsAPlane) {
  const EntityPtr wall = definedPtr(T::line, {3.0, 0.0, 3.0, 1.0});
  const EntityPtr floor = definedPtr(T::plane, {0.0, 0.0, 1.0, 2.0});
  const EntityPtr other = definedPtr(T::plane, {0.0, 1.0, 0.0, 5.0});
  expectCanon(defined(T::point, {W::INTOF, wall, floor, other}).canon, {3, 5, 2}, 1e-15);
}

TEST(ByHand, PatternPointsCountFromOne) {
  const EntityPtr row = definedPtr(T::pattern, {W::LINEAR, point(0, 0), point(4, 0, 2), 3.0});
  expectCanon(defined(T::point, {row, 2.0}).canon, {2, 0, 1}, 1e-15);
}

TEST(ByHand, ConicsOfCoefficients) {
  expectCanon(defined(T::gconic, {1.0, 2.0, 3.0, 4.0, 5.0, -6.0}).canon,
              {1, 3, 0, -6, 0, 0, 1, 2, 2.5, 0}, 0);
  // y = 2x + 3 +- sqrt(x^2 + 4x + 5): (y - 2x - 3)^2 - x^2 - 4x - 5 = 3x^2 - 4xy + y^2 + 8x - 6y +
  // 4
  expectCanon(defined(T::gconic, {2.0, 3.0, 1.0, 4.0, 5.0}).canon, {3, 1, 0, 4, 0, 0, -2, 4, -3, 0},
              0);
  expectCanon(defined(T::gconic, {2.0, 3.0, 1.0, 4.0, 5.0, W::FUNOFY}).canon,
              {1, 3, 0, 4, 0, 0, -2, -3, 4, 0}, 0);
}

TEST(ByHand, QuadricsOfPlacesLinesAndSpheresFarAwayAreTaken) {
  // One place, a line, a sphere of radius 1 about (1e6, 0, 0), two planes, a parabolic cylinder.
  for (const P& k : {P{1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                     P{1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
                     P{1.0, 1.0, 1.0, 0.0, 0.0, 0.0, -2e6, 0.0, 0.0, 1e12 - 1.0},
                     P{1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -4.0},
                     P{0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0}}) {
    EXPECT_NE(definedPtr(T::quadric, k), nullptr);
  }
}

TEST(ByHand, ConicsOfPointsAreTheUnitCircle) {
  const double h = std::sqrt(0.5);
  const auto isUnitCircle = [](const Entity& conic) {
    const std::vector<double>& c = conic.canon;
    for (const double v :
         {c[1] / c[0] - 1.0, c[3] / c[0] + 1.0, c[6] / c[0], c[7] / c[0], c[8] / c[0]}) {
      EXPECT_NEAR(v, 0.0, 1e-12);
    }
  };
  isUnitCircle(defined(T::lconic, {W::W_5PT, 1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0, h, h}));
  isUnitCircle(
      defined(T::lconic, {W::W_4PT1SL, point(0, 1), 0.0, point(1, 0), point(-1, 0), point(0, -1)}));
  isUnitCircle(defined(T::lconic, {W::W_3PT2SL, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0}));
}

TEST(ByHand, MirrorsAndFrames) {
  expectCanon(defined(T::matrix, {W::MIRROR, W::XYPLAN, W::ZXPLAN}).canon,
              {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0}, 0);
  // The rotation acts first: (1, 0) -> (0, 1) -> (5, 1)
  expectCanon(defined(T::matrix, {W::XYROT, 90.0, W::TRANSL, 5.0, 0.0}).canon,
              {0, -1, 0, 5, 1, 0, 0, 0, 0, 0, 1, 0}, 0);
  // The translation acts first: (0, 0) -> (5, 0) -> (0, 5)
  expectCanon(defined(T::matrix, {W::TRANSL, 5.0, 0.0, W::XYROT, 90.0}).canon,
              {0, -1, 0, 0, 1, 0, 0, 5, 0, 0, 1, 0}, 0);
}

TEST(ByHand, CopiesReplaceItems) {
  const EntityPtr p = point(1, 2, 3);
  EXPECT_EQ(defined(T::point, {p, W::CANON, Omitted{}, 7.0}).canon, (std::vector<double>{1, 7, 3}));
  EXPECT_EQ(defined(T::point, {p, W::CANON}).canon, (std::vector<double>{1, 2, 3}));
}

TEST(ByHand, LineCanonKeepsFourNumbersAndIsReadAsAUnitNormal) {
  const EntityPtr numbers = definedPtr(T::line, {W::CANON, 3.0, 4.0, 0.0, 10.0});
  EXPECT_EQ(numbers->canon, (std::vector<double>{3, 4, 0, 10}));
  expectCanon(defined(T::line, {point(0, 0), W::PARLEL, numbers}).canon, {0.6, 0.8, 0, 0}, 1e-15);
}

TEST(ByHand, ALineTurnedOutOfXyIsAPlaneAndACircleACylinder) {
  const EntityPtr m = definedPtr(T::matrix, {W::YZROT, 90.0});
  const std::span<const double, 12> matrix(m->canon);
  const Entity plane = *transformed(*definedPtr(T::line, {0.0, 2.0, 1.0, 2.0}), matrix);
  EXPECT_EQ(plane.type, T::plane);
  expectCanon(plane.canon, {0, 0, -1, -2}, 1e-15);
  const Entity cylinder = *transformed(*definedPtr(T::circle, {1.0, 2.0, 3.0}), matrix);
  EXPECT_EQ(cylinder.type, T::cylinder);
  expectCanon(cylinder.canon, {1, 0, 2, 0, -1, 0, 3}, 1e-15);
}

TEST(ByHand, WhatCannotBeMovedIsRefused) {
  const EntityPtr m = definedPtr(T::matrix, {W::SCALE, 2.0});
  const EntityPtr stretch = make(T::matrix, {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
  EXPECT_EQ(codeOf(transformed(*m, std::span<const double, 12>(m->canon)).failure()),
            "NotTransformable");
  EXPECT_EQ(codeOf(transformed(*definedPtr(T::circle, {0.0, 0.0, 1.0}),
                               std::span<const double, 12>(stretch->canon))
                       .failure()),
            "NotSimilar");
}

TEST(ByHand, ParabolaThroughThreePoints) {
  // Three nodes, FOURPT: the parabola v = u (2 - u) over both chords; checked at x = 0.5.
  const EntityPtr curve =
      definedPtr(T::tabulatedCylinder, {W::NOZ, W::FOURPT, 0.0, 0.0, 2.0, 0.0, 4.0, 8.0});
  const auto surface = geometry::TabulatedCylinder::of(curve->canon);
  // First chord is the x axis: v = e t (t - 2) through (4, 8): e = 1.
  EXPECT_NEAR(surface.intervals[1].offset(1.0), -1.0, 1e-15);
}

TEST(ByHand, SplineOfPointsOfALineIsTheLine) {
  const auto s = geometry::TabulatedCylinder::of(
      defined(T::tabulatedCylinder, {W::NOZ, W::SPLINE, 0.0, 0.0, 1.0, 1.0, 3.0, 3.0, 4.0, 4.0})
          .canon);
  ASSERT_EQ(s.intervals.size(), 5U);
  for (const auto& i : s.intervals) {
    EXPECT_NEAR(i.a, 0.0, 1e-14);
    EXPECT_NEAR(i.b, 0.0, 1e-14);
  }
  EXPECT_TRUE(s.intervals.front().extension && s.intervals.back().extension);
}

TEST(ByHand, SplineHasOneTangentAndOneCurvatureAtEveryPoint) {
  const auto s = geometry::TabulatedCylinder::of(
      defined(T::tabulatedCylinder, {W::NOY, W::SPLINE, 0.15, -7.0, 0.95, -4.5, 1.25, -2.0, 0.85,
                                     0.5, 0.55, 2.5, 1.15, 5.0, 1.35, 7.5})
          .canon);
  EXPECT_EQ(s.generatrix(), Vec3(0, 1, 0));
  for (std::size_t i = 1; i + 2 < s.intervals.size(); ++i) {
    const auto end = s.intervals[i].at(s.intervals[i].length);
    const auto start = s.intervals[i + 1].at(0.0);
    const auto cross = [](const auto& a, const auto& b) { return a.x() * b.y() - a.y() * b.x(); };
    EXPECT_NEAR((end.place - start.place).norm(), 0.0, 1e-12);
    EXPECT_NEAR(cross(end.tangent, start.tangent), 0.0, 1e-12);
    const double before = cross(end.tangent, end.second) / std::pow(end.tangent.norm(), 3);
    const double behind = cross(start.tangent, start.second) / std::pow(start.tangent.norm(), 3);
    EXPECT_NEAR(before, behind, 1e-10);
  }
}

TEST(ByHand, SplineTakesASharpTurn) {
  // A turn of 111 degrees at the third point, from the old system's program g17.
  const P data{W::NOZ, W::SPLINE, 1.25, 2.5, 2.5, 3.25, 3.35, 4.45, 5.35, 1.45, 6.35, 0.45};
  const auto s = geometry::TabulatedCylinder::of(defined(T::tabulatedCylinder, data).canon);
  const auto curvature = [](const geometry::CurvePoint& p) {
    return (p.tangent.x() * p.second.y() - p.tangent.y() * p.second.x()) /
           std::pow(p.tangent.norm(), 3);
  };
  for (std::size_t i = 1; i + 2 < s.intervals.size(); ++i) {
    const auto end = s.intervals[i].at(s.intervals[i].length);
    const auto start = s.intervals[i + 1].at(0.0);
    EXPECT_NEAR((end.tangent.normalized() - start.tangent.normalized()).norm(), 0.0, 1e-12);
    EXPECT_NEAR(curvature(end), curvature(start), 1e-9);
    EXPECT_LT(s.intervals[i].highest - s.intervals[i].lowest, 0.6 * s.intervals[i].length);
  }
}

TEST(ByHand, GivenSlopesAndNormalsAreTaken) {
  for (const P& data :
       {P{W::NOZ, W::PTSLOP, 0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 4.0, 0.0, -0.5},
        P{W::NOZ, W::PTNORM, 0.0, 0.0, 135.0, 2.0, 1.0, 90.0, 4.0, 0.0, 90.0 - 26.565051177077990},
        P{W::NOZ, W::TWOPT, point(0, 0), W::SLOPE, 1.0, 2.0, 1.0, W::NORMAL, 90.0, 4.0, 0.0,
          W::SLOPE, -0.5}}) {
    const auto s = geometry::TabulatedCylinder::of(defined(T::tabulatedCylinder, data).canon);
    const auto slope = [&](std::size_t i, double t) {
      const auto tangent = s.intervals[i].at(t).tangent;
      return tangent.y() / tangent.x();
    };
    EXPECT_NEAR(slope(1, 0.0), 1.0, 1e-12);
    EXPECT_NEAR(slope(2, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(slope(2, s.intervals[2].length), -0.5, 1e-12);
  }
}

TEST(ByHand, CanonOfATabulatedCylinderComesBack) {
  const Entity curve =
      defined(T::tabulatedCylinder, {W::NOX, W::SPLINE, 0.0, 0.0, 1.0, 1.0, 3.0, 0.5});
  P again{W::CANON};
  again.insert(again.end(), curve.canon.begin(), curve.canon.end());
  EXPECT_EQ(defined(T::tabulatedCylinder, again).canon, curve.canon);
  EXPECT_EQ(geometry::TabulatedCylinder::of(curve.canon).canon().size(), curve.canon.size());
}

TEST(ByHand, CurvesOfRadiiAndAngles) {
  const EntityPtr curve = definedPtr(
      T::tabulatedCylinder, {W::RTHETA, W::SPLINE, 1.0, 0.0, 1.0, 30.0, 1.0, 60.0, 1.0, 90.0});
  const auto s = geometry::TabulatedCylinder::of(curve->canon);
  EXPECT_NEAR(s.intervals[2].start.y(), 0.5, 1e-15);
  // Equal chords and mirrored ends: every tangent is 15 degrees off its chord, every cubic the
  // parabola with these ends; its middle is L tan(15)/4 above the chord, which is cos(15) from the
  // center.
  const double fifteen = std::acos(-1.0) / 12.0;
  const double length = 2.0 * std::sin(fifteen);
  EXPECT_NEAR(s.intervals[2].at(0.5 * s.intervals[2].length).place.norm(),
              std::cos(fifteen) + length * std::tan(fifteen) / 4.0, 1e-12);
}

TEST(ByHand, TangentAndNormalOfACurveThroughAPoint) {
  // A symmetric hump: from its foot on the axis of symmetry the normal is upright, the tangent at
  // the top level.
  const EntityPtr hump = definedPtr(T::tabulatedCylinder,
                                    {W::NOZ, W::SPLINE, -2.0, 0.0, -1.0, 1.0, 1.0, 1.0, 2.0, 0.0});
  const auto s = geometry::TabulatedCylinder::of(hump->canon);
  const double top = s.intervals[2].at(0.5 * s.intervals[2].length).place.y();
  expectCanon(defined(T::line, {point(0, -3), W::PERPTO, hump, point(-1, 1)}).canon, {1, 0, 0, 0},
              1e-9);
  const Entity tangent = defined(T::line, {point(-9, top), W::TANTO, hump, point(-1, 1)});
  EXPECT_NEAR(std::abs(tangent.canon[1]), 1.0, 1e-9);
  const EntityPtr low = definedPtr(T::line, {0.0, -5.0, 1.0, -5.0});
  const EntityPtr upright = definedPtr(T::line, {0.0, 0.0, 0.0, 1.0});
  expectCanon(defined(T::point, {W::INTOF, upright, hump, point(-1, 1)}).canon, {0, top, 0}, 1e-12);
  const Entity circle = defined(
      T::circle, {W::TANTO, upright, W::XLARGE, hump, W::YLARGE, point(-1, 1), W::RADIUS, 0.25});
  const auto nearest = geometry::nearestOn(s, {circle.canon[0], circle.canon[1]});
  EXPECT_NEAR(circle.canon[0], 0.25, 1e-12);
  EXPECT_NEAR(nearest.distance, 0.25, 1e-9);
  EXPECT_GT(circle.canon[1], top);
}

TEST(ByHand, GridsRunToAndFro) {
  const EntityPtr column = definedPtr(T::pattern, {W::LINEAR, point(0, 0), point(0, 2), 3.0});
  const EntityPtr row = definedPtr(T::pattern, {W::LINEAR, point(4, 2), point(0, 2), 2.0});
  const Entity grid = defined(T::pattern, {W::PARLEL, column, row});
  EXPECT_EQ(grid.canon,
            (std::vector<double>{0, 0, 0, 0, 1, 0, 0, 2, 0, 4, 2, 0, 4, 1, 0, 4, 0, 0}));
  EXPECT_EQ(grid.pattern.columns, 2);
  EXPECT_EQ(grid.pattern.kind, PatternShape::Kind::parallel);
}

TEST(ByHand, GroupsOfStepsRepeat) {
  const EntityPtr x = make(T::vector, {2, 0, 0});
  const Entity row = defined(
      T::pattern, {W::LINEAR, point(0, 0), x, W::INCR, 2.0, W::AT, 1.0, W::INCR, 1.0, W::AT, 5.0});
  EXPECT_EQ(row.canon, (std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0, 7, 0, 0}));
  const Entity list =
      defined(T::pattern, {W::RANDOM, point(9, 9), std::make_shared<const Entity>(row)});
  EXPECT_EQ(list.canon.size(), 15U);
}

TEST(ByHand, RuledSurfaceBetweenTwoArches) {
  const EntityPtr tube = make(T::cylinder, {0, 0, 0, 0, 1, 0, 5});
  const EntityPtr up = make(T::vector, {0, 0, 1});
  const Entity surface = defined(T::ruledSurface, {tube, point(-3, 0, 4), point(3, 0, 4), up, tube,
                                                   point(-4, 8, 3), point(4, 8, 3), up});
  const auto ruled = geometry::RuledSurface::of(surface.canon);
  EXPECT_EQ(ruled.canon(), surface.canon);
  const auto middle = ruled.at(0.5, 0.25);
  ASSERT_TRUE(middle);
  EXPECT_NEAR((middle->place - Vec3(0, 2, 5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((middle->byF - Vec3(6.5, 0, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((middle->byG - Vec3(0, 8, 0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((*ruled.normal(0.5, 0.25) - Vec3(0, 0, 1)).norm(), 0.0, 1e-9);
  const Entity fan = defined(
      T::ruledSurface, {tube, point(-3, 0, 4), point(3, 0, 4), point(0, 0, 5), point(0, 9, 0)});
  EXPECT_NEAR((geometry::RuledSurface::of(fan.canon).at(0.0, 1.0)->place - Vec3(0, 9, 0)).norm(),
              0.0, 1e-12);
}

TEST(ByHand, TorusHasEightNumbers) {
  expectCanon(defined(T::torus, {point(1, 2, 3), make(T::vector, {0, 0, 2}), 5.0, 1.0}).canon,
              {1, 2, 3, 0, 0, 1, 5, 1}, 0);
}

/// Parabolas in planes of a system without matrix: jroots 1, pb 10, A = B = 1 and P = 3/4.
TEST(ByHand, PolyconicIsCanonicalOnly) {
  std::vector<double> values(79, 0.0);
  values[0] = 1.0;
  values[15] = 10.0;
  values[16] = values[24] = 1.0;
  values[64] = 0.75;
  P numbers{W::CANON};
  numbers.insert(numbers.end(), values.begin(), values.end());
  EXPECT_EQ(defined(T::polyconic, numbers).canon, values);
}

TEST(ByHand, FromOneZsurfToAnother) {
  Context tilted{0.0, 1.0, 1.0, 4.0};  // y + z = 4
  expectCanon(defined(T::point, {3.0, 1.0}, tilted).canon, {3, 1, 3}, 0);
  expectCanon(defined(T::circle, {3.0, 1.0, 2.0}, tilted).canon, {3, 1, 0, 0, 0, 1, 2}, 0);
}

TEST(ByHand, VectorOfAnEighthTurn) {
  expectCanon(defined(T::vector, {W::LENGTH, r2, W::ATANGL, 45.0, W::YZPLAN}).canon, {0, 1, 1},
              1e-15);
}

}  // namespace
}  // namespace arelem::define::test
