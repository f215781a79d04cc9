#include "runtime/stencil/engrave.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/runtime/stencil/alphabets.h"

namespace arelem::stencil {
namespace {

Engraving engravingOf(const std::string& text, double height) {
  Engraving e;
  e.text = text;
  e.placement.height = height;
  e.chord = 0.01;
  return e;
}
std::vector<PenLine> linesOf(const Engraving& e, const Alphabet& alphabet) {
  auto made = penLines(e, alphabet, Limits{}, Vec2::Zero());
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.failure().message);
  return *std::move(made);
}
double near(const Vec2& a, const Vec2& b) {
  return (a - b).norm();
}

/// HT on a grid of 4 by 6, 12 tall: 8 wide, 3 between, 8 wide.
TEST(Engrave, LettersStandSideBySide) {
  const auto lines = linesOf(engravingOf("LT", 12.0), roadway());
  ASSERT_EQ(lines.size(), 3U);
  ASSERT_EQ(lines[0].symbol, "L");
  ASSERT_EQ(lines[0].points.size(), 3U);
  EXPECT_LT(near(lines[0].points[1], Vec2(0.0, 0.0)), 1e-9);
  // The L is 3.5 of the grid wide, then 1.5: the T begins at 5 of 2 mm each.
  double left = 1e9;
  double right = 0.0;
  for (const PenLine& line : lines) {
    if (line.symbol == "T") {
      for (const Vec2& p : line.points) {
        left = std::min(left, p.x());
        right = std::max(right, p.x());
      }
    }
  }
  EXPECT_NEAR(left, 10.0, 1e-9);
  EXPECT_NEAR(right, 18.0, 1e-9);
}

TEST(Engrave, WidthSpaceAngleAndOrigin) {
  Engraving e = engravingOf("II", 12.0);
  e.width = 20.0;  // of a letter of usual width: 5 for a grid unit
  e.placement.space = 7.0;
  e.placement.angle = 90.0;
  e.placement.origin = Vec2(100.0, 50.0);
  const auto lines = linesOf(e, roadway());
  ASSERT_EQ(lines.size(), 2U);
  // An I has no width; written upwards it runs to -x.
  EXPECT_NEAR(std::abs(lines[0].points[0].y() - lines[1].points[0].y()), 7.0, 1e-9);
  EXPECT_NEAR(std::abs(lines[0].points[0].x() - lines[0].points[1].x()), 12.0, 1e-9);
}

/// An O, 6 tall: two half circles of radius 2 and two lines of 2.
TEST(Engrave, ChordsKeepTheTolerance) {
  for (const double chord : {0.1, 0.01, 0.001}) {
    Engraving e = engravingOf("O", 6.0);
    e.chord = chord;
    const auto lines = linesOf(e, roadway());
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].isClosed());
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < lines[0].points.size(); ++i) {
      const Vec2 middle = 0.5 * (lines[0].points[i] + lines[0].points[i + 1]);
      const double y = std::clamp(middle.y(), 2.0, 4.0);
      worst = std::max(worst, std::abs(near(middle, Vec2(2.0, y)) - 2.0));
    }
    EXPECT_LE(worst, chord);
    EXPECT_GT(worst, 0.2 * chord);  // and not many times as many as that takes
  }
}

TEST(Engrave, SplinesKeepTheTolerance) {
  const Alphabet alphabet =
      alphabetOf("GRID 4 25\nPENGRID 4 6 1\nSYMBOL S\nPEN SPLINE 0,9 0,0 4,6 4,-3\n");
  Engraving e = engravingOf("S", 60.0);
  for (const double chord : {1.0, 0.05}) {
    e.chord = chord;
    const auto lines = linesOf(e, alphabet);
    const Piece curve = alphabet.symbols[0].pens[0].pieces[0];
    const auto& points = lines[0].points;
    double worst = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const double count = static_cast<double>(points.size() - 1);
      for (double t = 0.1; t < 1.0; t += 0.1) {
        const Vec2 p = 10.0 * pointOf(curve, (static_cast<double>(i) + t) / count);
        const Vec2 step = (points[i + 1] - points[i]).normalized();
        const Vec2 off = p - points[i];
        worst = std::max(worst, std::abs(off.x() * step.y() - off.y() * step.x()));
      }
    }
    EXPECT_LE(worst, chord);
    EXPECT_GT(worst, 0.1 * chord);
  }
}

/// Without pen lines: the middles of the strokes.
TEST(Engrave, MiddlesOfStrokes) {
  const Alphabet alphabet =
      alphabetOf("GRID 4 25\nSYMBOL I WIDTH 1\nSTROKE 5 0,0 1,0 TO 0,25 1,25\n");
  const auto lines = linesOf(engravingOf("I", 12.0), alphabet);
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].points.size(), 2U);
  EXPECT_LT(near(lines[0].points[0], Vec2(1.0, 0.0)), 1e-9);
  EXPECT_LT(near(lines[0].points[1], Vec2(1.0, 12.0)), 1e-9);
}

/// All symbols have pen lines, and these stand on their grid.
TEST(Engrave, PenLinesOfTheRoadwayAlphabet) {
  const Alphabet alphabet = roadway();
  for (const Symbol& symbol : alphabet.symbols) {
    EXPECT_FALSE(symbol.pens.empty()) << symbol.name;
    double low = 1e9;
    double high = 0.0;
    for (const PenLine& line : linesOf(engravingOf(symbol.name, 6.0), alphabet)) {
      for (const Vec2& p : line.points) {
        EXPECT_GT(p.x(), -1e-6) << symbol.name;
        EXPECT_LT(p.x(), 5.0 + 1e-6) << symbol.name;
        low = std::min(low, p.y());
        high = std::max(high, p.y());
      }
    }
    if (symbol.name != "-") {
      EXPECT_NEAR(low, 0.0, 0.01) << symbol.name;
      EXPECT_GT(high, symbol.name.size() > 1 ? 5.4 : 5.99) << symbol.name;
      EXPECT_LT(high, 6.0 + 1e-6) << symbol.name;
    }
  }
}

TEST(Engrave, Refusals) {
  const Alphabet alphabet = roadway();
  const auto code = [&](const Engraving& e, Limits limits = {}) {
    auto made = penLines(e, alphabet, limits, Vec2::Zero());
    EXPECT_FALSE(made.ok());
    return made.ok() ? std::string() : std::string(made.takeFailure().row->code);
  };
  EXPECT_EQ(code(engravingOf("A%", 6.0)), "E0560");
  EXPECT_EQ(code(engravingOf(" ", 6.0)), "E0563");
  Engraving fine = engravingOf("O", 6.0);
  fine.chord = 1e-30;
  EXPECT_EQ(code(fine), "E0564");
  Limits few;
  few.points = 10;
  EXPECT_EQ(code(engravingOf("OOO", 6.0), few), "E0564");
}

}  // namespace
}  // namespace arelem::stencil
