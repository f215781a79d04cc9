#include "runtime/stencil/rails.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "runtime/stencil/cell.h"

namespace arelem::stencil {
namespace {

TEST(Cell, LeanSaysWhichEdgeIsLonger) {
  // A trapezoid, 3 long at the first edge and 5 at the second: (5 - 3) / (5 + 3).
  const Line from{{0.0, 0.0}, {0.0, 2.0}};
  const Line to{{3.0, 0.0}, {5.0, 2.0}};
  EXPECT_NEAR(balanceOf(from, to).lean, 0.25, 1e-15);
  EXPECT_NEAR(balanceOf(from, to).area, 8.0, 1e-15);
  EXPECT_NEAR(balanceOf({from.second, from.first}, {to.second, to.first}).lean, -0.25, 1e-15);
  // Lines that cross: the cell is folded.
  EXPECT_GT(std::abs(balanceOf(from, {{1.0, 0.0}, {-0.5, 2.0}}).lean), 1.0);
  EXPECT_EQ(balanceOf(from, from).lean, 0.0);
}

/// The closed form of the paint against the rays of the nozzle: even in the tangent of their angle
/// to the middle of the fan.
TEST(Cell, PaintFollowsTheRays) {
  constexpr double radian = std::numbers::pi / 180.0;
  for (const double fan : {20.0, 63.5, 110.0}) {
    for (const double tilt : {-12.0, 0.0, 3.0, 18.0}) {
      const Tilted gun = placeTilted(1.0, fan, tilt);
      for (double s = 0.0; s <= 1.0; s += 0.125) {
        const double angle = std::atan2(s - 0.5 - gun.shift, gun.height) + tilt * radian;
        const double paint = 0.5 + 0.5 * std::tan(angle) / std::tan(0.5 * fan * radian);
        EXPECT_NEAR(paintUpTo(s, fan, tilt), paint, 1e-12) << fan << " " << tilt << " " << s;
      }
    }
  }
}

TEST(Cell, FilmOfAStripIsPaintOverArea) {
  // A triangle with its point at the first edge: 19/100 of the area lie in the last tenth.
  const auto film = filmOf(1.0, 1.0);
  EXPECT_NEAR(film.back(), 0.1 / 0.19, 1e-12);
  const Spread spread = spreadOf(1.0, 1.0);
  EXPECT_NEAR(spread.most, 0.1 / 0.01, 1e-9);
  EXPECT_NEAR(spread.least, 0.1 / 0.19, 1e-12);
  // The derivative of s / (s + m (1 - s)).
  EXPECT_NEAR(paintAt(0.5, 1.5), 1.5 / (1.25 * 1.25), 1e-12);
}

Rail railOf(const std::vector<Vec2>& points, int cells) {
  std::vector<double> shares;
  for (int i = 0; i <= cells; ++i) {
    shares.push_back(static_cast<double>(i) / cells);
  }
  Rail rail;
  rail.extend(points, shares, false);
  return rail;
}

TEST(Rails, PlacesAreLengths) {
  const Rail rail = railOf({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, 7);
  EXPECT_DOUBLE_EQ(rail.length(), 7.0);
  EXPECT_NEAR((rail.at(5.0) - Vec2(3.0, 2.0)).norm(), 0.0, 1e-15);
  EXPECT_TRUE(rail.isCorner(3));
  for (const std::size_t line : {0, 1, 2, 4, 5, 6, 7}) {
    EXPECT_FALSE(rail.isCorner(line)) << line;
  }
}

TEST(Rails, GoOnWithTheNextStroke) {
  Rail rail = railOf({{0.0, 0.0}, {2.0, 0.0}}, 2);
  rail.extend({{2.0, 0.0}, {6.0, 0.0}}, {0.0, 0.25, 1.0}, true);
  EXPECT_EQ(rail.places(), (std::vector<double>{0.0, 1.0, 2.0, 3.0, 6.0}));
  rail.extend({{7.0, 0.0}, {9.0, 0.0}}, {0.0, 1.0}, false);
  EXPECT_EQ(rail.places().back(), 9.0);
  EXPECT_EQ(rail.places()[5], 7.0);
}

double worstLean(const std::vector<Line>& lines) {
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    worst = std::max(worst, std::abs(balanceOf(lines[i], lines[i + 1]).lean));
  }
  return worst;
}

/// Two edges of 10 whose second is divided badly, with a lean of (6 - 2) / (6 + 2). Leans of a
/// quarter, films within 2 %, are not worth uneven cells: about there they stay.
TEST(Rails, EvenEdgesAreDividedEvenly) {
  const Rail first = railOf({{0.0, 0.0}, {10.0, 0.0}}, 5);
  Rail second;
  second.extend({{0.0, 1.0}, {10.0, 1.0}}, {0.0, 0.1, 0.2, 0.3, 0.4, 1.0}, false);
  const std::vector<Line> lines = evenlyLeaning(first, second, 0.01);
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_LT(worstLean(lines), 0.26);
  EXPECT_EQ(lines.front().second, Vec2(0.0, 1.0));
  EXPECT_EQ(lines.back().second, Vec2(10.0, 1.0));
}

/// A quarter ring behind a straight piece: the edges are 4 + pi / 2 and 4 + pi long. With the same
/// share of both in each cell the ring's lean of 1/3 would fall to (pi - pi / 2) / (8 + 3 pi / 2).
TEST(Rails, ABendSharesItsLeanWithTheStraightBeforeIt) {
  std::vector<Vec2> inner = {{-4.0, 1.0}};
  std::vector<Vec2> outer = {{-4.0, 2.0}};
  for (int i = 0; i <= 64; ++i) {
    const double angle = 0.5 * std::numbers::pi * (1.0 - i / 64.0);
    inner.emplace_back(std::cos(angle), std::sin(angle));
    outer.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle));
  }
  const auto stroke = [](const std::vector<Vec2>& points) {
    Rail rail;
    rail.extend({points[0], points[1]}, {0.0, 0.25, 0.5, 0.75, 1.0}, false);
    std::vector<double> shares;
    for (int i = 0; i <= 8; ++i) {
      shares.push_back(i / 8.0);
    }
    rail.extend({points.begin() + 1, points.end()}, shares, true);
    return rail;
  };
  const Rail first = stroke(inner);
  const Rail second = stroke(outer);
  std::vector<Line> given;
  for (std::size_t i = 0; i < first.places().size(); ++i) {
    given.push_back({first.at(first.places()[i]), second.at(second.places()[i])});
  }
  EXPECT_NEAR(worstLean(given), 1.0 / 3.0, 1e-3);
  EXPECT_LT(worstLean(evenlyLeaning(first, second, 0.05)), 0.26);
}

/// The sides of cells stay as near to the edge as they are allowed to leave it.
TEST(Rails, MovedLinesDoNotCutTheBend) {
  std::vector<Vec2> inner;
  std::vector<Vec2> outer;
  for (int i = 0; i <= 256; ++i) {
    const double angle = std::numbers::pi * i / 256.0;
    inner.emplace_back(std::cos(angle), std::sin(angle));
    outer.emplace_back(2.5 * std::cos(angle), 2.0 * std::sin(angle));
  }
  const Rail first = railOf(inner, 16);
  const Rail second = railOf(outer, 16);
  for (const double bow : {0.02, 0.2}) {
    const std::vector<Line> lines = evenlyLeaning(first, second, bow);
    double worst = 0.0;  // of the outer edge, seen as an ellipse
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const Vec2 middle = 0.5 * (lines[i].second + lines[i + 1].second);
      worst = std::max(worst, 1.0 - Vec2(middle.x() / 2.5, middle.y() / 2.0).norm());
    }
    EXPECT_LT(2.0 * worst, 1.1 * bow + 0.02);
  }
}

}  // namespace
}  // namespace arelem::stencil
