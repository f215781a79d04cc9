#include "runtime/stencil/alphabet.h"

#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/stencil/cell.h"
#include "runtime/stencil/message.h"
#include "tests/unit/runtime/stencil/alphabets.h"

namespace arelem::stencil {
namespace {

using testing::HasSubstr;

/// Blank's table 2.1: the primitives of each letter.
TEST(Alphabet, LettersAreMadeOfTheirPrimitives) {
  const std::map<std::string, std::set<int>> table = {
      {"A", {4, 5}}, {"B", {1, 5}},    {"C", {2, 4}},    {"D", {1, 5}}, {"E", {5}},
      {"F", {5}},    {"G", {2, 4, 5}}, {"H", {5}},       {"I", {5}},    {"J", {2, 4}},
      {"K", {4, 5}}, {"L", {5}},       {"M", {4, 5}},    {"N", {4, 5}}, {"O", {2, 4}},
      {"P", {1, 5}}, {"Q", {2, 4}},    {"R", {1, 4, 5}}, {"S", {2, 3}}, {"T", {5}},
      {"U", {2, 4}}, {"V", {4}},       {"W", {4, 5}},    {"X", {4}},    {"Y", {4, 5}},
      {"Z", {4, 5}}};
  const Alphabet alphabet = roadway();
  for (const auto& [letter, primitives] : table) {
    const Symbol* symbol = alphabet.find(letter);
    ASSERT_NE(symbol, nullptr) << letter;
    std::set<int> used;
    for (const Stroke& stroke : symbol->strokes) {
      used.insert(stroke.primitive);
    }
    EXPECT_EQ(used, primitives) << letter;
  }
  for (const std::string name :
       {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "-", "<AHEAD>", "<LEFT>", "<RIGHT>"}) {
    EXPECT_NE(alphabet.find(name), nullptr) << name;
  }
}

/// Strokes stay on the grid (the source's hook overshoots it by 0.2) and fill a fair part of it.
TEST(Alphabet, SymbolsFitTheirGrid) {
  const Alphabet alphabet = roadway();
  for (const Symbol& symbol : alphabet.symbols) {
    double area = 0.0;
    double top = 0.0;
    double foot = 25.0;
    for (const Stroke& stroke : symbol.strokes) {
      const auto lines =
          linesOf(stroke, symbol.width, alphabet.height, stroke.cells, Division::equal);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        for (const Vec2& p : {lines[i].first, lines[i].second}) {
          EXPECT_GT(p.x(), -0.01) << symbol.name;
          EXPECT_LT(p.x(), symbol.width + 0.01) << symbol.name;
          EXPECT_GT(p.y(), -0.21) << symbol.name;
          EXPECT_LT(p.y(), 25.21) << symbol.name;
          top = std::max(top, p.y());
          foot = std::min(foot, p.y());
        }
        area += i > 0 ? areaOf(lines[i - 1], lines[i]) : 0.0;
      }
    }
    if (symbol.name != "-") {
      EXPECT_GT(top, 24.9) << symbol.name;
      EXPECT_LT(foot, 0.1) << symbol.name;
    }
    EXPECT_GT(area, 10.0) << symbol.name;  // the hyphen: 3 by 4
    EXPECT_LT(area, 0.85 * symbol.width * 25.0 + 5.0) << symbol.name;
  }
}

/// Mirror images have mirrored lines: the left arrow is the right one seen from behind.
TEST(Alphabet, LeftAndRightArrowsMirror) {
  const Alphabet alphabet = roadway();
  const Symbol* left = alphabet.find("<LEFT>");
  const Symbol* right = alphabet.find("<RIGHT>");
  ASSERT_EQ(left->strokes.size(), right->strokes.size());
  for (std::size_t i = 0; i < left->strokes.size(); ++i) {
    const auto a = linesOf(left->strokes[i], 5.0, 25.0, left->strokes[i].cells, Division::equal);
    const auto b = linesOf(right->strokes[i], 5.0, 25.0, right->strokes[i].cells, Division::equal);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(a[k].first.x(), 5.0 - b[k].first.x(), 1e-9);
      EXPECT_NEAR(a[k].second.x(), 5.0 - b[k].second.x(), 1e-9);
      EXPECT_NEAR(a[k].first.y(), b[k].first.y(), 1e-9);
    }
  }
}

TEST(Alphabet, EqualDivisionIsEqual) {
  const Alphabet alphabet = roadway();
  const Shape& bowl = *alphabet.find("P")->strokes[1].shape;
  for (const Edge* edge : {&bowl.first, &bowl.second}) {
    const std::vector<Vec2> fine = divideEdge(*edge, 4000, Division::equal);
    double shortest = 1e9;
    double longest = 0.0;
    for (int part = 0; part < 20; ++part) {
      double length = 0.0;
      for (int k = 0; k < 200; ++k) {
        length += (fine[part * 200 + k + 1] - fine[part * 200 + k]).norm();
      }
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    EXPECT_LT(longest / shortest - 1.0, 5e-4);
  }
  // The inner edge is a quarter circle of radius 2 and a line of 1: pi + 1.
  EXPECT_NEAR(Measured(bowl.first).length(), 3.14159265358979 + 1.0, 1e-9);
}

struct Bad {
  const char* text;
  const char* message;
};

TEST(Alphabet, DamageIsNamedWithItsPlace) {
  const std::vector<Bad> all = {
      {"", "line 1, column 1: the file ends without GRID"},
      {"SYMBOL A", "line 1, column 1: `SYMBOL` stands where GRID is expected"},
      {"GRID 4", "line 1, column 7: the end of the line stands where a positive height"},
      {"GRID 4 -25", "line 1, column 8: `-25` stands where a positive height"},
      {"GRID 4 25 9", "line 1, column 11: `9` stands where the end of the line"},
      {"GRID 4 nan", "`nan` stands where"},
      {"GRID 4 1e400", "`1e400` stands where"},
      {"GRID 4 25\n\n", "without a SYMBOL"},
      {"GRID 4 25\nSTROKE 5 0,0 1,0 TO 0,1 1,1",
       "line 2, column 1: a stroke stands before the first SYMBOL"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0",
       "line 3, column 17: the end of the line stands where TO"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 0,0 TO 1,1 2,2",
       "line 3, column 10: a fan line of length 0"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 7", "line 3, column 8: there is no primitive 7 above"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,1 1,1 JOIN", "nothing to JOIN"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,1 1,1 TWIST", "`TWIST` stands where FLIPX"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,1 1,1 CELLS 0",
       "`0` stands where a number of cells"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,1 1,1 CELLS 2.5", "`2.5` stands where"},
      {"GRID 4 25\nSYMBOL A\nSYMBOL A", "line 3, column 8: `A` is there already"},
      {"GRID 4 25\nSYMBOL <a>", "stands where one printable character"},
      {"GRID 4 25\nSYMBOL \x01", "`?` stands where one printable character"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST FROM 0,0 LINE 1,1\nSYMBOL A",
       "needs a FIRST and a SECOND edge"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST ARC 0,0 1,1 90,0 SPLINE 9,9 8,8 7,7 6,6",
       "begins at 8,8 but the one before it ends at 1,0"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST ARC 0,0 1,0 90,0", "an arc needs positive radii"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST LINE 0,0", "`LINE` stands where SPLINE, ARC or FROM"},
      {"GRID 4 25\nFIRST FROM 0,0 LINE 1,1", "an edge stands outside a PRIMITIVE"},
      {"GRID 4 25\nPRIMITIVE 1\nPRIMITIVE 1", "needs a FIRST"},
      // Strokes that a fan cannot paint.
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,0 1,0",
       "line 3, column 1: a stroke: between the "
       "fan lines 0,0 1,0 and 0,0 1,0 there is "
       "no area"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 2,0 3,0", "there is no area"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 1,25 0,25", "the edges cross"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,25 1,25 TO 0,5 1,5", "turns back"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST FROM 0,0 LINE 0,25\nSECOND FROM 1,25 LINE 1,0\nSYMBOL A",
       "line 5, column 1: the primitive before this line: between the fan lines"},
      {"GRID 4 25\nPRIMITIVE 1\nFIRST ARC 2,12 2,2 0,720", "at most 360 degrees apart"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,10 1,10\nSTROKE 5 0,10 1,10 TO 0,0 1,0 JOIN",
       "turns back"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,10 1,10\nSTROKE 5 1,10 0,10 TO 1,25 0,25 JOIN",
       "turn round in place"},
      {"GRID 4 25\nSYMBOL A\nSTROKE 5 0,0 1,0 TO 0,10 1,10\nSTROKE 5 2,12 3,12 TO 2,25 3,25 JOIN",
       "line 4, column 1: the stroke before ends with the fan line 0,10 1,10 and this one begins "
       "with 2,12 3,12"},
  };
  for (const Bad& bad : all) {
    const auto read = readAlphabet(bad.text, "x.alphabet");
    ASSERT_FALSE(read.ok()) << bad.text;
    EXPECT_THAT(read.failure().message, HasSubstr(bad.message)) << bad.text;
    EXPECT_EQ(read.failure().row->code, "E0740");
  }
}

TEST(Alphabet, SizesAreBounded) {
  std::string text = "GRID 4 25\nSYMBOL A\n";
  for (int i = 0; i < 201; ++i) {
    text += "STROKE 5 0,0 1,0 TO 0,1 1,1\n";
  }
  const auto read = readAlphabet(text, "x");
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.failure().row->code, "E0741");
}

/// Any damage to the shipped file is read or refused, never worse.
TEST(Alphabet, SurvivesRandomDamage) {
  const std::string good = roadwayText();
  std::mt19937 random(20261122);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = random() % text.size();
      switch (random() % 3) {
        case 0:
          text[at] = static_cast<char>(random() % 256);
          break;
        case 1:
          text.erase(at, random() % 40);
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), 7));
      }
    }
    const auto read = readAlphabet(text, "x");
    refused += read.ok() ? 0 : 1;
    if (read.ok()) {
      const auto runs = runsOf("ABS8", *read, {Vec2::Zero(), 100.0, 0.0, std::nullopt}, {}, {});
      EXPECT_TRUE(runs.ok() || runs.failure().row->code == "E0560");
    }
  }
  EXPECT_GT(refused, 50);
}

}  // namespace
}  // namespace arelem::stencil
