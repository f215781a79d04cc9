// Where the gun sprays, against the footprint itself: the gun is on at every place from which its
// ellipse meets the work, whatever the shape.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "runtime/spray/offset_curve.h"
#include "runtime/spray/passes.h"

namespace arelem::spray {
namespace {

bool inside(const Outline& outline, const Vec2& p) {
  std::size_t crossings = 0;
  for (const Loop& loop : outline.loops) {
    for (const double x : hits(loop, p.y())) {
      crossings += x > p.x() ? 1U : 0U;
    }
  }
  return crossings % 2 == 1;
}

/// Distance of a place from the outline where the footprint is a unit circle; 0 inside.
double reach(const Outline& outline, const Footprint& print, const Vec2& place) {
  if (inside(outline, place)) {
    return 0.0;
  }
  const Vec2 scale(1.0 / print.along, 1.0 / print.across);
  const Vec2 p = place.cwiseProduct(scale);
  double least = HUGE_VAL;
  for (const Loop& loop : outline.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i].cwiseProduct(scale);
      const Vec2 b = loop[(i + 1) % loop.size()].cwiseProduct(scale);
      const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - t * (b - a)).norm());
    }
  }
  return least;
}

bool covers(const std::vector<Interval>& intervals, double x) {
  for (const Interval& i : intervals) {
    if (x >= i.from - 1e-9 && x <= i.to + 1e-9) {
      return true;
    }
  }
  return false;
}

/// A star of random radii: corners of all kinds, never crossing itself.
Outline star(std::mt19937& random, double size, const Vec2& center, bool clockwise) {
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  const int n = 5 + static_cast<int>(random() % 12);
  Loop loop;
  for (int i = 0; i < n; ++i) {
    const double angle = 2.0 * M_PI * i / n * (clockwise ? -1.0 : 1.0);
    loop.push_back(center + size * radius(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return {{loop}};
}

TEST(SprayedArea, IsWhereTheFootprintMeetsTheWork) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-160.0, 160.0);
  for (int round = 0; round < 200; ++round) {
    Outline outline = star(random, 100.0, {0.0, 0.0}, false);
    if (round % 2 == 1) {
      outline.loops.push_back(star(random, 15.0, {0.0, 0.0}, true).loops[0]);
    }
    const Footprint print = {5.0 + static_cast<double>(random() % 30),
                             5.0 + static_cast<double>(random() % 30)};
    const SprayedArea area(outline, print, PassRules::mitreLimit);
    for (int i = 0; i < 60; ++i) {
      const Vec2 p(place(random), place(random));
      const double distance = reach(outline, print, p);
      const bool on = covers(area.at(p.y()), p.x());
      if (distance < 1.0 - 1e-9) {
        EXPECT_TRUE(on) << round << ": " << p.transpose() << " is " << distance;
      } else if (distance > PassRules::mitreLimit) {
        EXPECT_FALSE(on) << round << ": " << p.transpose() << " is " << distance;
      }
    }
  }
}

TEST(SprayedArea, AHoleSmallerThanTheFootprintIsSprayedOver) {
  // The offset of the hole's edges would pass each other and leave a wrong gap.
  const Outline outline = {
      {{{0, 0}, {400, 0}, {400, 300}, {0, 300}}, {{195, 155}, {205, 155}, {205, 145}, {195, 145}}}};
  const SprayedArea area(outline, {43.4, 62.0}, PassRules::mitreLimit);
  for (const double y : {100.0, 146.0, 150.0, 154.0, 200.0}) {
    ASSERT_EQ(area.at(y).size(), 1U) << y;
  }
}

TEST(SprayedArea, ANarrowSlotIsSprayedOver) {
  const Outline outline = {
      {{{0, 0}, {400, 0}, {400, 300}, {210, 300}, {210, 50}, {190, 50}, {190, 300}, {0, 300}}}};
  const SprayedArea area(outline, {43.4, 62.0}, PassRules::mitreLimit);
  for (const double y : {60.0, 200.0, 290.0}) {
    const auto pieces = area.at(y);
    ASSERT_EQ(pieces.size(), 1U) << y;
    EXPECT_NEAR(pieces[0].from, -43.4, 1e-9);
    EXPECT_NEAR(pieces[0].to, 443.4, 1e-9);
  }
}

/// Pieces of a line that lie inside curves, by the half-open rule.
std::vector<Interval> piecesInside(const Outline& curve, double height) {
  std::vector<double> all;
  for (const Loop& loop : curve.loops) {
    const std::vector<double> own = hits(loop, height);
    all.insert(all.end(), own.begin(), own.end());
  }
  std::sort(all.begin(), all.end());
  std::vector<Interval> pieces;
  for (std::size_t i = 1; i < all.size(); i += 2) {
    pieces.push_back({all[i - 1], all[i]});
  }
  return pieces;
}

/// Passes are found strip by strip, in doubles; the curve is one exact union. They must agree.
TEST(OffsetCurve, ItsHitsAreThoseOfThePasses) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> height(-130.0, 130.0);
  std::size_t compared = 0;
  for (int round = 0; round < 150; ++round) {
    Outline outline = star(random, 100.0, {0.0, 0.0}, false);
    if (round % 2 == 1) {
      outline.loops.push_back(star(random, 15.0, {0.0, 0.0}, true).loops[0]);
    }
    const Footprint print = {round % 10 == 0 ? 0.0 : 1.0 + static_cast<double>(random() % 30),
                             1.0 + static_cast<double>(random() % 30)};
    const SprayedArea area(outline, print, PassRules::mitreLimit);
    const Outline curve = offsetCurve(outline, print, PassRules::mitreLimit);
    for (int i = 0; i < 20; ++i) {
      const double y = height(random);
      const std::vector<Interval> ours = area.at(y);
      const std::vector<Interval> exact = piecesInside(curve, y);
      ASSERT_EQ(ours.size(), exact.size()) << round << " at " << y;
      for (std::size_t k = 0; k < ours.size(); ++k, ++compared) {
        EXPECT_NEAR(ours[k].from, exact[k].from, 1e-6);
        EXPECT_NEAR(ours[k].to, exact[k].to, 1e-6);
      }
    }
  }
  EXPECT_GT(compared, 2000U);
}

/// A square of side 100 with a = 20 and b = 10: mitred, 140 by 120.
TEST(OffsetCurve, OfASquare) {
  const Outline square = {{{{0, 0}, {100, 0}, {100, 100}, {0, 100}}}};
  const Outline curve = offsetCurve(square, {20.0, 10.0}, PassRules::mitreLimit);
  ASSERT_EQ(curve.loops.size(), 1U);
  EXPECT_NEAR(areaOf(curve), 140.0 * 120.0, 1e-9);
}

/// A hole of 50 by 50 keeps 10 by 30; one of 30 by 30 is closed by the spray across its width.
TEST(OffsetCurve, OfHoles) {
  Outline plate = {{{{0, 0}, {300, 0}, {300, 100}, {0, 100}},
                    {{20, 20}, {20, 70}, {70, 70}, {70, 20}},
                    {{200, 20}, {200, 50}, {230, 50}, {230, 20}}}};
  const Outline curve = offsetCurve(plate, {20.0, 10.0}, PassRules::mitreLimit);
  ASSERT_EQ(curve.loops.size(), 2U);
  EXPECT_NEAR(areaOf(curve), 340.0 * 120.0 - 10.0 * 30.0, 1e-9);
}

TEST(Passes, AStripNarrowerThanTheInsetsGetsOnePassInItsMiddle) {
  const Outline strip = {{{{0, 0}, {400, 0}, {400, 20}, {0, 20}}}};
  PassRules rules;
  rules.footprint = {40.0, 40.0};
  rules.overlap = 0.175;
  rules.inset = 21.0;
  const PassPlan plan = planPasses(strip, rules);
  ASSERT_EQ(plan.passes.size(), 1U);
  EXPECT_DOUBLE_EQ(plan.passes[0].height, 10.0);
}

TEST(Passes, IslandsApartAreSprayedOneAfterAnother) {
  const Outline two = {
      {{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, {{0, 500}, {100, 500}, {100, 600}, {0, 600}}}};
  PassRules rules;
  rules.footprint = {10.0, 10.0};
  const PassPlan plan = planPasses(two, rules);
  for (std::size_t i = 0; i < plan.passes.size(); ++i) {
    const double y = plan.passes[i].height;
    EXPECT_TRUE((y > -10.0 && y < 110.0) || (y > 490.0 && y < 610.0)) << y;
    const bool toRight = plan.passes[i].hits.front() < plan.passes[i].hits.back();
    EXPECT_EQ(toRight, i % 2 == 0);
  }
}

}  // namespace
}  // namespace arelem::spray
