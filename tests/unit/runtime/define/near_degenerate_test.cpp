// Selections next to the position where the modifier decides nothing: the answer is right, or it is
// refused with what was measured; never the other candidate. The offset d runs over both signs from
// 0.1 to 1e-15.
#include <cmath>
#include <functional>

#include "runtime/geometry/shapes.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

EntityPtr line(double x1, double y1, double x2, double y2) {
  return definedPtr(T::line, {x1, y1, x2, y2});
}
EntityPtr circle(double x, double y, double r) {
  return definedPtr(T::circle, {x, y, r});
}
EntityPtr plane(double a, double b, double c, double d) {
  return definedPtr(T::plane, {a, b, c, d});
}

struct Selection {
  std::string name;
  EntityType type;
  std::function<P(double)> parameters;        ///< for an offset d
  std::function<double(const Entity&)> side;  ///< must have the sign of d
};

void check(const Selection& s, double d) {
  SCOPED_TRACE(s.name + " d = " + std::to_string(d * 1e15) + "e-15");
  const Result<Entity> result = define(s.type, s.parameters(d), {});
  if (!result) {
    const std::string code = codeOf(result.failure());
    EXPECT_TRUE(code == "Undecided" || code == "NoSense") << code;
    EXPECT_LE(std::abs(d), 1e-8) << "refused though it is decided: " << result.failure().message;
    EXPECT_FALSE(result.failure().notes.empty());
    return;
  }
  EXPECT_GT(s.side(*result) * d, 0.0) << "the wrong branch";
}

std::vector<Selection> selections() {
  const auto y = [](const Entity& e) { return e.canon[1]; };
  const auto ellipse = definedPtr(T::ellipse, {W::CENTER, point(0, 0), 2.0, 1.0, 0.0});
  return {
      // An almost upright line through a circle: d > 0 leans right, the larger x is above.
      {"PT_04", T::point,
       [](double d) {
         return P{W::XLARGE, W::INTOF, line(-d, -1, d, 1), circle(0, 0, 3)};
       },
       y},
      {"PT_08", T::point,
       [=](double d) {
         return P{W::XLARGE, W::INTOF, line(-d, -1, d, 1), ellipse};
       },
       y},
      // Centers almost on a level: the second one d lower, so that the upper point is to the right.
      {"PT_05", T::point,
       [](double d) {
         return P{W::XLARGE, W::INTOF, circle(-2, 0, 3), circle(2, -d, 3)};
       },
       [](const Entity& e) { return e.canon[1]; }},
      // A normal (d, 1): XLARGE takes the one with positive x, which points up where d > 0.
      {"LN_14", T::line,
       [](double d) {
         return P{W::PARLEL, line(0, 0, 1, -d), W::XLARGE, 5.0};
       },
       [](const Entity& e) { return e.canon[1] * e.canon[3]; }},
      {"PL_04", T::plane,
       [](double d) {
         return P{W::PARLEL, plane(0, 1, d, 0), W::ZLARGE, 5.0};
       },
       [](const Entity& e) { return e.canon[1] * e.canon[3]; }},
      {"VE_04", T::vector,
       [](double d) {
         return P{W::PERPTO, plane(0, 1, d, 0), W::POSZ};
       },
       y},
      {"VE_10", T::vector,
       [](double d) {
         return P{W::PARLEL, W::INTOF, plane(0, 0, 1, 0), plane(1, -d, 0, 0), W::POSX};
       },
       y},
      {"VE_13", T::vector,
       [](double d) {
         return P{W::ATANGL, 90.0 - d, line(0, 0, 1, 0), W::POSX};
       },
       y},
      // The side of each line by an almost level normal.
      {"CI_09", T::circle,
       [](double d) {
         return P{W::XLARGE, line(0, 0, 1, -d), W::XLARGE, line(0, 0, 0, 1), W::RADIUS, 2.0};
       },
       y},
      {"CI_11", T::circle,
       [](double d) {
         return P{W::XLARGE,       line(-d, -1, d, 1), W::XLARGE, W::OUT,
                  circle(0, 0, 3), W::RADIUS,          1.0};
       },
       y},
      {"CI_12", T::circle,
       [](double d) {
         return P{W::XLARGE, W::OUT, circle(-2, 0, 3), W::OUT, circle(2, -d, 3), W::RADIUS, 1.0};
       },
       y},
  };
}

TEST(NearDegenerate, SelectionsAreRightOrRefused) {
  for (const Selection& s : selections()) {
    for (int power = 1; power <= 15; ++power) {
      const double d = std::pow(10.0, -power);
      check(s, d);
      check(s, -d);
    }
    const Result<Entity> none = define(s.type, s.parameters(0.0), {});
    EXPECT_FALSE(none.ok()) << s.name << ": exactly between the candidates";
  }
}

/// Far from the origin the coordinates themselves are rounded: no branch may be taken by chance.
TEST(NearDegenerate, FarFromTheOrigin) {
  constexpr double far = 1e6;
  for (int power = 1; power <= 15; ++power) {
    for (const double d : {std::pow(10.0, -power), -std::pow(10.0, -power)}) {
      const EntityPtr leaning = line(far - d, far - 1, far + d, far + 1);
      const auto p = define(T::point, P{W::XLARGE, W::INTOF, leaning, circle(far, far, 3)}, {});
      // What the line really is, after its coordinates were rounded.
      const double lean = (far + d) - (far - d);
      if (p) {
        EXPECT_GT((p->canon[1] - far) * lean, 0.0) << d;
      } else {
        EXPECT_EQ(codeOf(p.failure()), "Undecided");
        EXPECT_LE(std::abs(lean), 1e-6) << p.failure().message;
      }
    }
  }
}

/// Almost parallel planes: the direction of their common line is known to rounding over the sine.
TEST(NearDegenerate, AlmostParallelPlanes) {
  for (int power = 1; power <= 8; ++power) {
    const double sine = std::pow(10.0, -power);
    for (int other = 1; other <= 15; ++other) {
      for (const double d : {std::pow(10.0, -other), -std::pow(10.0, -other)}) {
        const auto v = define(
            T::vector,
            P{W::PARLEL, W::INTOF, plane(0, 0, 1, 0), plane(sine, -sine * d, 1, 0), W::POSX}, {});
        if (v) {
          EXPECT_GT(v->canon[1] * d, 0.0) << sine << " " << d;
        } else {
          EXPECT_LE(std::abs(d) * sine, 1e-9) << v.failure().message;
        }
      }
    }
  }
}

/// Next to a tangent position there is one point within the coincidence distance of both curves,
/// two points, or none.
TEST(NearDegenerate, TangentPositions) {
  for (int power = 2; power <= 15; ++power) {
    for (const double d : {std::pow(10.0, -power), -std::pow(10.0, -power), 0.0}) {
      const auto p =
          define(T::point, P{W::XLARGE, W::INTOF, line(0, 3 + d, 1, 3 + d), circle(0, 0, 3)}, {});
      if (p) {
        EXPECT_NEAR(std::hypot(p->canon[0], p->canon[1]), 3.0, 1.1e-5) << d;
        EXPECT_NEAR(p->canon[1], 3.0 + d, 1e-12) << d;
      } else {
        EXPECT_GT(d, 0.9e-5) << p.failure().message;
      }
      const auto q =
          define(T::point, P{W::YLARGE, W::INTOF, circle(0, 0, 3), circle(5 + d, 0, 2)}, {});
      EXPECT_EQ(q.ok(), d < 1.1e-5) << d;
      if (q) {
        EXPECT_NEAR(std::hypot(q->canon[0], q->canon[1]), 3.0, 1.1e-5) << d;
        EXPECT_NEAR(std::hypot(q->canon[0] - 5 - d, q->canon[1]), 2.0, 1.1e-5) << d;
      }
      const auto t = define(T::line, P{point(3 + d, 0), W::LEFT, W::TANTO, circle(0, 0, 3)}, {});
      EXPECT_EQ(t.ok(), d > -1.1e-5) << d;
      if (t) {
        EXPECT_NEAR(std::abs(geometry::Line::of(t->canon).height({0.0, 0.0})), 3.0, 1.1e-5) << d;
      }
    }
  }
}

/// A point next to the line that its circle touches: on it the modifier speaks, off it the point's
/// side.
TEST(NearDegenerate, PointNextToATangentLine) {
  for (int power = 3; power <= 15; ++power) {
    for (const double d : {std::pow(10.0, -power), -std::pow(10.0, -power), 0.0}) {
      const auto c = define(
          T::circle, P{W::TANTO, line(0, 0, 1, 0), W::YLARGE, point(4, d), W::RADIUS, 2.0}, {});
      if (c) {
        EXPECT_NEAR(std::abs(c->canon[1]), 2.0, 1.1e-5) << d;
        EXPECT_NEAR(std::hypot(c->canon[0] - 4, c->canon[1] - d), 2.0, 1.1e-5) << d;
        EXPECT_GT(c->canon[1] * (std::abs(d) <= 1e-5 ? 1.0 : d), 0.0) << d;
      } else {
        EXPECT_EQ(codeOf(c.failure()), "Undecided") << d;
      }
    }
  }
}

}  // namespace
}  // namespace arelem::define::test
