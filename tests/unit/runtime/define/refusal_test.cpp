// Definitions without a unique result: each is refused with its own diagnostic and says what was
// measured.
#include <gmock/gmock.h>

#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

using testing::HasSubstr;

EntityPtr line(double x1, double y1, double x2, double y2) {
  return definedPtr(T::line, {x1, y1, x2, y2});
}
EntityPtr circle(double x, double y, double r) {
  return make(T::circle, {x, y, 0, 0, 0, 1, r});
}
EntityPtr plane(double a, double b, double c, double d) {
  return definedPtr(T::plane, {a, b, c, d});
}
EntityPtr vector(double x, double y, double z) {
  return make(T::vector, {x, y, z});
}
EntityPtr matrix(std::vector<double> m) {
  return make(T::matrix, std::move(m));
}
EntityPtr wave() {
  return definedPtr(T::tabulatedCylinder,
                    {W::NOZ, W::SPLINE, 0.0, 0.0, 1.0, 1.0, 2.0, 0.0, 3.0, -1.0, 4.0, 0.0});
}

struct Case {
  EntityType type;
  P parameters;
  std::string diagnostic;
};

void expectRefused(const std::vector<Case>& cases) {
  int number = 0;
  for (const Case& c : cases) {
    SCOPED_TRACE("case " + std::to_string(++number));
    EXPECT_EQ(codeOf(refused(c.type, c.parameters)), c.diagnostic);
  }
}

TEST(Refusal, Points) {
  const EntityPtr unit = circle(0, 0, 1);
  const EntityPtr upright = line(0.5, 0, 0.5, 1);
  expectRefused({
      {T::point, {W::INTOF, line(0, 0, 1, 1), line(0, 1, 1, 2)}, "Parallel"},
      {T::point, {W::XLARGE, W::INTOF, line(0, 2, 1, 2), unit}, "NoIntersection"},
      {T::point, {W::XLARGE, W::INTOF, upright, unit}, "Undecided"},
      {T::point, {W::XLARGE, W::INTOF, unit, circle(1, 0, 1)}, "Undecided"},
      {T::point, {W::XLARGE, W::INTOF, unit, circle(0, 0, 2)}, "Coincident"},
      {T::point, {W::XLARGE, W::INTOF, unit, circle(3, 0, 1)}, "NoIntersection"},
      {T::point, {W::XLARGE, W::INTOF, unit, circle(0.5, 0, 3)}, "NoIntersection"},
      {T::point, {W::INTOF, plane(0, 0, 1, 0), plane(0, 0, 1, 1), plane(1, 0, 0, 0)}, "Parallel"},
      {T::point,
       {W::XLARGE, W::INTOF, line(0, 3, 1, 3),
        definedPtr(T::ellipse, {W::CENTER, point(0, 0), 2.0, 1.0, 0.0})},
       "NoIntersection"},
      {T::point,
       {definedPtr(T::pattern, {W::LINEAR, point(0, 0), point(1, 0), 3.0}), 4.0},
       "PatternIndex"},
      {T::point,
       {definedPtr(T::pattern, {W::LINEAR, point(0, 0), point(1, 0), 3.0}), 1.5},
       "PatternIndex"},
  });
}

TEST(Refusal, Lines) {
  const EntityPtr unit = circle(0, 0, 1);
  expectRefused({
      {T::line, {1.0, 2.0, 1.0, 2.0}, "NullDirection"},
      {T::line, {point(1, 2, 0), point(1, 2, 9)}, "NullDirection"},
      {T::line, {point(0.5, 0), W::LEFT, W::TANTO, unit}, "NoTangent"},
      {T::line, {W::LEFT, W::TANTO, unit, W::LEFT, W::TANTO, circle(0.1, 0, 3)}, "NoTangent"},
      {T::line, {W::LEFT, W::TANTO, unit, W::RIGHT, W::TANTO, circle(1.5, 0, 1)}, "NoTangent"},
      {T::line, {W::LEFT, W::TANTO, unit, W::LEFT, W::TANTO, unit}, "Coincident"},
      {T::line, {W::PARLEL, line(0, 0, 0, 1), W::YLARGE, 1.0}, "NoSense"},
      {T::line, {W::INTOF, plane(1, 0, 0, 0), plane(0, 1, 0, 0)}, "Parallel"},
      {T::line, {W::INTOF, plane(0, 0, 1, 0), plane(0, 0, 1, 3)}, "Parallel"},
  });
}

TEST(Refusal, PlanesAndVectors) {
  const EntityPtr floor = plane(0, 0, 1, 0);
  expectRefused({
      {T::plane, {0.0, 0.0, 0.0, 1.0}, "NullDirection"},
      {T::plane, {point(0, 0), point(1, 1), point(2, 2)}, "Collinear"},
      {T::plane, {W::PARLEL, floor, W::XLARGE, 1.0}, "NoSense"},
      {T::plane, {point(0, 0), W::PERPTO, vector(0, 0, 0)}, "NullDirection"},
      {T::plane, {W::PERPTO, floor, point(1, 1, 0), point(1, 1, 5)}, "NullDirection"},
      {T::plane, {point(0, 0), W::PERPTO, floor, plane(0, 0, 1, 4)}, "Parallel"},
      {T::vector, {W::PERPTO, floor, W::POSX}, "NoSense"},
      {T::vector, {W::UNIT, 0.0, 0.0, 0.0}, "NullDirection"},
      {T::vector, {W::PARLEL, W::INTOF, floor, plane(0, 0, 2, 1), W::POSX}, "Parallel"},
      {T::vector, {W::PARLEL, W::INTOF, floor, plane(0, 1, 0, 1), W::POSZ}, "NoSense"},
      {T::vector, {W::ATANGL, 90.0, line(0, 0, 1, 0), W::POSX}, "NoSense"},
  });
}

TEST(Refusal, Circles) {
  const EntityPtr axis = line(0, 0, 1, 0);
  const EntityPtr unit = circle(0, 0, 1);
  expectRefused({
      {T::circle, {0.0, 0.0, 0.0}, "BadRadius"},
      {T::circle, {W::CENTER, point(0, 0), W::RADIUS, -1.0}, "BadRadius"},
      {T::circle, {W::CENTER, point(3, 0), W::TANTO, axis}, "BadRadius"},
      {T::circle, {point(0, 0), point(1, 1), point(3, 3)}, "Collinear"},
      {T::circle, {W::CENTER, point(1, 0), W::SMALL, W::TANTO, unit}, "BadRadius"},
      {T::circle, {W::YLARGE, axis, W::YSMALL, line(0, 3, 1, 3), W::RADIUS, 1.0}, "Parallel"},
      {T::circle, {W::XLARGE, axis, W::XLARGE, line(0, 0, 0, 1), W::RADIUS, 1.0}, "NoSense"},
      {T::circle, {W::TANTO, axis, W::XLARGE, point(0, 5), W::RADIUS, 1.0}, "NoIntersection"},
      {T::circle, {W::TANTO, axis, W::YLARGE, point(0, 1), W::RADIUS, 1.0}, "Undecided"},
      {T::circle,
       {W::YLARGE, line(0, 5, 1, 5), W::XLARGE, W::OUT, unit, W::RADIUS, 1.0},
       "NoIntersection"},
      {T::circle, {W::YLARGE, axis, W::YLARGE, W::OUT, unit, W::RADIUS, 1.0}, "Undecided"},
      {T::circle, {W::XLARGE, W::OUT, unit, W::OUT, circle(4, 0, 1), W::RADIUS, 2.0}, "Undecided"},
      {T::circle,
       {W::XLARGE, W::OUT, unit, W::OUT, circle(9, 0, 1), W::RADIUS, 2.0},
       "NoIntersection"},
      {T::circle,
       {W::TANTO, line(1000, 0, 1000, 1), W::XLARGE, wave(), W::YLARGE, point(1, 1), W::RADIUS,
        0.1},
       "NoPlaceOnCurve"},
  });
}

TEST(Refusal, Solids) {
  expectRefused({
      {T::cylinder, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, "NullDirection"},
      {T::cylinder, {point(0, 0), vector(0, 0, 1), 0.0}, "BadRadius"},
      {T::cone, {point(0, 0), vector(0, 0, 0), 30.0}, "NullDirection"},
      {T::cone, {point(0, 0), vector(0, 0, 1), 90.0}, "BadRange"},
      {T::cone, {point(0, 0), vector(0, 0, 1), 0.0}, "BadRange"},
      {T::sphere, {point(0, 0), 0.0}, "BadRadius"},
      {T::sphere, {point(0, 0), point(1, 0), point(0, 1), point(1, 1)}, "Coplanar"},
      {T::torus, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0}, "BadRadius"},
      {T::torus, {point(0, 0), vector(0, 0, 0), 2.0, 1.0}, "NullDirection"},
      {T::ellipse, {W::CENTER, point(0, 0), 0.0, 1.0, 0.0}, "BadRange"},
      {T::hyperbola, {W::CENTER, point(0, 0), 1.0, -1.0, 0.0}, "BadRange"},
      {T::gconic, {0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, "BadConic"},
      {T::quadric, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, "BadConic"},
      // x^2 + y^2 + z^2 + 10, x^2 + y^2 + 10, (x - 1)^2 + y^2 + z^2 + 1 and z^2 + 1 are 0 nowhere.
      {T::quadric, {1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0}, "BadConic"},
      {T::quadric, {1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0}, "BadConic"},
      {T::quadric, {-1.0, -1.0, -1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, -2.0}, "BadConic"},
      {T::quadric, {0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}, "BadConic"},
      {T::gconic, {1.0, 0.0, 1.0, 0.0, 0.0, 4.0}, "BadConic"},
      {T::lconic, {W::W_5PT, 0.0, 0.0, 1.0, 0.0, 2.0, 1.0, 3.0, 3.0, 2.0, 0.0}, "BadConic"},
      {T::lconic, {W::W_3PT2SL, point(0, 0), 0.0, point(1, 1), 0.0, point(0, 0)}, "BadConic"},
      {T::lconic,
       {W::W_4PT1SL, point(0, 0), 0.0, point(1, 1), point(2, 1), point(5, 0)},
       "BadConic"},
  });
}

TEST(Refusal, Matrices) {
  const EntityPtr flat = matrix({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
  expectRefused({
      {T::matrix, {W::INVERS, flat}, "NoInverse"},
      {T::matrix, {plane(1, 0, 0, 0), plane(1, 1, 0, 0), plane(0, 0, 1, 0)}, "NotPerpendicular"},
      {T::matrix, {point(0, 0), vector(1, 0, 0), vector(-2, 0, 0)}, "Parallel"},
      {T::matrix, {point(0, 0), vector(0, 0, 0), vector(0, 1, 0)}, "NullDirection"},
  });
}

TEST(Refusal, Curves) {
  const EntityPtr tilted = definedPtr(T::matrix, {W::YZROT, 30.0});
  expectRefused({
      {T::tabulatedCylinder, {W::NOZ, W::SPLINE, 0.0, 0.0, 1.0, 1.0}, "TooFewPoints"},
      {T::tabulatedCylinder,
       {W::NOZ, W::SPLINE, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 2.0, 0.0},
       "Coincident"},
      {T::tabulatedCylinder,
       {W::NOZ, W::SPLINE, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0001, 2.0, 0.0},
       "CurveTurnsBack"},
      {T::tabulatedCylinder,
       {W::NOZ, W::SPLINE, W::TRFORM, tilted, 0.0, 0.0, 1.0, 1.0, 2.0, 0.0},
       "LeavesPlane"},
      {T::tabulatedCylinder,
       {W::NOZ, W::FOURPT, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0},
       "FoldedCubic"},
      {T::tabulatedCylinder,
       {W::NOZ, W::PTSLOP, 0.0, 0.0, 1e5, 1.0, 0.0, 0.0, 2.0, 0.0, 0.0},
       "TangentAcrossChord"},
      {T::tabulatedCylinder,
       {W::XYZ, W::SPLINE, vector(0, 0, 0), 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 2.0, 0.0, 0.0},
       "NullDirection"},
      {T::tabulatedCylinder,
       {W::NOZ, W::FOURPT, 0.0, 0.0, W::SLOPE, 1.0, 1.0, 1.0, 2.0, 0.0},
       "WrongModifier"},
      {T::line,
       {point(0, 9), W::PERPTO,
        definedPtr(T::tabulatedCylinder, {W::NOX, W::SPLINE, 0.0, 0.0, 1.0, 1.0, 2.0, 0.0}),
        point(0, 0)},
       "NotVertical"},
  });
}

TEST(Refusal, Patterns) {
  const EntityPtr row = definedPtr(T::pattern, {W::LINEAR, point(0, 0), point(1, 0), 3.0});
  const EntityPtr list = definedPtr(T::pattern, {W::RANDOM, point(0, 0), row});
  expectRefused({
      {T::pattern, {W::LINEAR, point(0, 0), point(1, 0), 1.0}, "BadRange"},
      {T::pattern, {W::LINEAR, point(0, 0), point(1, 0), 2.5}, "BadRange"},
      {T::pattern, {W::LINEAR, point(0, 0), vector(1, 0, 0), 1e9}, "PatternTooLarge"},
      {T::pattern, {W::LINEAR, point(0, 0), vector(0, 0, 0), W::INCR, 1.0}, "NullDirection"},
      {T::pattern, {W::PARLEL, list, vector(1, 0, 0), 3.0}, "PatternNotLinear"},
      {T::pattern,
       {W::PARLEL, row, definedPtr(T::pattern, {W::LINEAR, point(0, 7), point(0, 9), 3.0})},
       "PatternsApart"},
  });
}

TEST(Refusal, RuledSurfaces) {
  const EntityPtr tube = make(T::cylinder, {0, 0, 0, 0, 1, 0, 5});
  expectRefused({
      {T::ruledSurface,
       {tube, point(0, 0, 5), point(0.01, 0, 5), point(0, 0, 6), point(0, 9)},
       "RuledEndsTooClose"},
      {T::ruledSurface,
       {tube, point(-3, 0, 4), point(3, 0, 4), point(1, 0, 4), point(0, 9)},
       "RuledPlaneUndefined"},
      {T::ruledSurface,
       {tube, point(-3, 0, 4), point(9, 0, 4), vector(0, 0, 1), point(0, 9)},
       "RuledCurveMissed"},
      {T::ruledSurface,
       {tube, point(-3, 0, 4), point(3, 0, 4), vector(2, 0, 0), point(0, 9)},
       "RuledPlaneUndefined"},
  });
}

TEST(Refusal, Canonical) {
  const EntityPtr p = point(1, 2, 3);
  expectRefused({
      {T::point, {W::CANON, 1.0, 2.0}, "WrongCanonicalCount"},
      {T::cylinder, {W::CANON, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0}, "NullDirection"},
      {T::sphere, {W::CANON, 0.0, 0.0, 0.0, -1.0}, "BadCanonicalValue"},
      {T::plane, {point(0, 0), W::PARLEL, make(T::plane, {0, 0, 0, 2})}, "NullDirection"},
      {T::circle, {W::CANON, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0}, "BadCanonicalValue"},
      {T::cone, {W::CANON, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0}, "BadCanonicalValue"},
      {T::line, {p, W::CANON}, "WrongCanonicalType"},
      {T::point, {p, W::CANON, 1.0, 2.0, 3.0, 4.0}, "WrongCanonicalCount"},
      {T::polyconic, {W::CANON, 1.0, 2.0}, "WrongCanonicalCount"},
      {T::tabulatedCylinder, {W::CANON, 3.0, 1.0, 1.0}, "WrongCanonicalCount"},
      {T::ruledSurface, {W::CANON, 13.0, 4.0, 0.0, 0.0, 0.0, 1.0}, "WrongCanonicalCount"},
      {T::ruledSurface, {W::CANON, 53.0, 4.0, 0.0, 0.0, 0.0, 1.0}, "BadCanonicalValue"},
      {T::mesh, {W::CANON, 1.0}, "WrongCanonicalCount"},
      {T::mesh,
       {W::CANON, 3.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 2.0, 4.0},
       "BadCanonicalValue"},
  });
}

TEST(Refusal, OverflowIsNoNumber) {
  EXPECT_EQ(codeOf(refused(T::vector, {1e308, 0.0, 0.0, -1e308, 0.0, 0.0})), "NotFinite");
}

TEST(Refusal, UndecidedNamesBothCandidates) {
  const Failure failure =
      refused(T::point, {W::XLARGE, W::INTOF, line(0.6, 0, 0.6, 1), circle(0, 0, 1)});
  ASSERT_EQ(failure.notes.size(), 2U);
  EXPECT_THAT(failure.notes[0] + failure.notes[1], HasSubstr("(0.6, 0.8)"));
  EXPECT_THAT(failure.notes[0] + failure.notes[1], HasSubstr("(0.6, -0.8)"));
}

TEST(Refusal, WrongModifierNamesThePlaceAndWhatFits) {
  const Failure failure =
      refused(T::point, {W::ZLARGE, W::INTOF, line(0, 0, 1, 1), circle(0, 0, 1)});
  EXPECT_EQ(codeOf(failure), "WrongModifier");
  EXPECT_EQ(
      failure.message,
      "parameter 1 of POINT is `ZLARGE`; `XLARGE`, `XSMALL`, `YLARGE` or `YSMALL` would fit there");
  EXPECT_THAT(failure.help,
              HasSubstr("POINT/ {XLARGE | XSMALL | YLARGE | YSMALL}, INTOF, line, circle"));
}

TEST(Refusal, MissingParameterIsNamed) {
  const Failure failure = refused(T::circle, {W::CENTER, point(0, 0), W::RADIUS});
  EXPECT_EQ(failure.message,
            "CIRCLE lacks a parameter, the number is 3: `r` would fit as parameter 4");
}

}  // namespace
}  // namespace arelem::define::test
