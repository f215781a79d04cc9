// The other solutions of a definition: by hand, and for every form that has a choice.
#include "runtime/define/alternatives.h"

#include <cmath>

#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

Alternatives of(EntityType type, const P& parameters) {
  auto found = alternatives(type, parameters, {});
  EXPECT_TRUE(found.ok()) << (found.ok() ? "" : found.failure().message);
  return found.ok() ? *std::move(found) : Alternatives();
}

std::size_t solutions(const Alternatives& all) {
  std::size_t n = 0;
  for (const Alternative& other : all.others) {
    n += other.result.ok() ? 1 : 0;
  }
  return n;
}

TEST(Alternatives, TheOtherIntersection) {
  const EntityPtr axis = definedPtr(T::line, {0.0, 0.0, 1.0, 0.0});
  const EntityPtr unit = definedPtr(T::circle, {0.0, 0.0, 1.0});
  const Alternatives found = of(T::point, {W::XLARGE, W::INTOF, axis, unit});
  expectCanon(found.chosen.canon, {1, 0, 0}, 1e-15);
  ASSERT_EQ(solutions(found), 1U);
  expectCanon(found.others.front().result->canon, {-1, 0, 0}, 1e-15);
  ASSERT_EQ(found.others.front().words.size(), 1U);
  EXPECT_EQ(found.others.front().words.front(), std::make_pair(std::size_t{0}, W::XSMALL));
  EXPECT_TRUE(found.all);
}

TEST(Alternatives, FourCirclesTouchTwoLines) {
  const EntityPtr across = definedPtr(T::line, {0.0, 0.0, 1.0, 0.0});
  const EntityPtr up = definedPtr(T::line, {0.0, 0.0, 0.0, 1.0});
  const Alternatives found = of(T::circle, {W::YLARGE, across, W::XLARGE, up, W::RADIUS, 2.0});
  expectCanon(found.chosen.canon, {2, 2, 0, 0, 0, 1, 2}, 1e-15);
  EXPECT_EQ(solutions(found), 3U);  // centers (2,-2), (-2,2), (-2,-2)
  for (const Alternative& other : found.others) {
    if (other.result.ok()) {
      EXPECT_DOUBLE_EQ(std::abs(other.result->canon[0]), 2.0);
      EXPECT_DOUBLE_EQ(std::abs(other.result->canon[1]), 2.0);
    }
  }
}

TEST(Alternatives, TangentsOfTwoCircles) {
  const EntityPtr a = definedPtr(T::circle, {0.0, 0.0, 1.0});
  const EntityPtr b = definedPtr(T::circle, {10.0, 0.0, 1.0});
  const Alternatives found = of(T::line, {W::LEFT, W::TANTO, a, W::LEFT, W::TANTO, b});
  EXPECT_EQ(solutions(found), 3U);  // two outer and two inner tangents
}

TEST(Alternatives, CombinationsWithoutAResultSayWhy) {
  // The line y = 12 is 3 from the circle of radius 9: circles of radius 2 touch both only from
  // outside, left and right of x = 0, below the line.
  const EntityPtr large = definedPtr(T::circle, {0.0, 0.0, 9.0});
  const EntityPtr line = definedPtr(T::line, {0.0, 12.0, 1.0, 12.0});
  const Alternatives found =
      of(T::circle, {W::YSMALL, line, W::XLARGE, W::OUT, large, W::RADIUS, 2.0});
  EXPECT_NEAR(found.chosen.canon[0], std::sqrt(21.0), 1e-12);  // 11 from the center, 10 high
  EXPECT_EQ(solutions(found), 1U);
  ASSERT_GE(found.others.size(), 2U);
  EXPECT_FALSE(found.others.back().result.ok());
  EXPECT_FALSE(found.others.back().result.failure().message.empty());
  EXPECT_FALSE(found.others.back().words.empty());
}

TEST(Alternatives, OtherPlacesOfACurve) {
  // Slopes 1 and -1 over a chord of 2: v = t - t^2 / 2, which is .375 at t = .5 and t = 1.5; the
  // second half of the curve lies below.
  const EntityPtr wave = definedPtr(
      T::tabulatedCylinder, {W::NOZ, W::PTSLOP, 0.0, 0.0, 1.0, 2.0, 0.0, -1.0, 4.0, 0.0, 1.0});
  const EntityPtr level = definedPtr(T::line, {0.0, 0.375, 1.0, 0.375});
  const Alternatives found = of(T::point, {W::INTOF, level, wave, point(0, 0)});
  EXPECT_NEAR(found.chosen.canon[0], 0.5, 1e-9);
  bool other = false;
  for (const Alternative& a : found.others) {
    ASSERT_TRUE(a.near.has_value());
    other = other || std::abs(a.result->canon[0] - 1.5) < 1e-9;
  }
  EXPECT_TRUE(other);
}

TEST(Alternatives, OtherFeetOnASpline) {
  // A U about the y axis, and a point above it a little right: the feet are on both arms. A spline
  // of collinear control points with equal steps is the straight line, away from its ends.
  const EntityPtr u = definedPtr(
      T::pathSpline, {point(-4, 9), point(-4, 6), point(-4, 3), point(-4, 0), point(-4, -3),
                      point(4, -3), point(4, 0), point(4, 3), point(4, 6), point(4, 9)});
  const Alternatives found = of(T::point, {u, point(1, 4)});
  EXPECT_NEAR(found.chosen.canon[0], 4.0, 1e-9);
  EXPECT_NEAR(found.chosen.canon[1], 4.0, 1e-6);
  ASSERT_EQ(solutions(found), 1U);
  EXPECT_NEAR(found.others.front().result->canon[0], -4.0, 1e-6);
  EXPECT_NEAR(found.others.front().result->canon[1], 4.0, 1e-6);
  EXPECT_TRUE(found.others.front().near.has_value());
}

TEST(Alternatives, WithoutAChoice) {
  const Alternatives found = of(T::point, {1.0, 2.0});
  EXPECT_EQ(found.tried, 0U);
  EXPECT_TRUE(found.others.empty());
}

TEST(Alternatives, FailsAsTheDefinitionDoes) {
  const EntityPtr a = definedPtr(T::line, {0.0, 0.0, 1.0, 0.0});
  const EntityPtr b = definedPtr(T::line, {0.0, 1.0, 1.0, 1.0});
  const P parameters = {W::INTOF, a, b};
  const auto found = alternatives(T::point, parameters, {});
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.failure().message, refused(T::point, parameters).message);
}

}  // namespace
}  // namespace arelem::define::test
