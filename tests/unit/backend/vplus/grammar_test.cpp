#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/vplus/reader.h"

namespace arelem::test {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& statement) {
  auto read = vplus::readProgram(".PROGRAM a()\n" + statement + "\n.END\n", "x.v2", nullptr);
  return read.ok() ? "" : read.failure().message;
}

TEST(VplusReader, TakesTheGrammar) {
  for (const char* good : {"AUTO REAL a, b[3]",
                           "LOCAL c\nGLOBAL d",
                           "100 MOVE HERE:TRANS(0,0,5)",
                           "APPROS f:TRANS(1,2,3,0,180,0), 50 ; near",
                           "DEPART 20",
                           "SPEED 30 ALWAYS",
                           "SPEED 250 MMPS ALWAYS",
                           "SPEED 250, 100 MMPS",
                           "SPEED 10 IPS",
                           "SPEED 50 MONITOR",
                           "ACCEL (1) 100, 80",
                           "DURATION 0.1 ALWAYS",
                           "COARSE 150 ALWAYS",
                           "NULL",
                           "SIGNAL 1, -2, 3001",
                           "SET p = RZ(30):SHIFT(q BY 1,,3)",
                           "SET p = SHIFT(q BY ,,3)",
                           "SET p = SHIFT(q BY 1)",
                           "x = 3*(4-2)/5",
                           "TOOL TRANS(0,0,180)",
                           "TOOL",
                           "BASE 1,2,,4",
                           "ENABLE CP",
                           "PARAMETER HAND.TIME = 0.5",
                           "TYPE \"hello\", x",
                           "CALL other(1, 2)",
                           "IF x > 3 THEN\nELSE\nEND",
                           "FOR i = 1 TO 5 STEP 2\nEND",
                           "WHILE x < 3 DO\nEND",
                           "LEFTY",
                           "move trans(652.0,432.0,(598.8+offset),0,180, 45.0)",
                           "speed (424.3*scale), rotate MMPS ",
                           "MOVE #PPOINT(1,2,3,4)"}) {
    EXPECT_EQ(refusal(good), "") << good;
  }
}

/// Behind MOVES, without BREAK, an output changes as that move begins: behind the one before.
TEST(VplusReader, SpeedsWaitsAndOutputsOfMoves) {
  const auto read = vplus::readProgram(
      ".PROGRAM a()\nTOOL TRANS(0,0,180)\nBASE 0,,5\nSPEED 100 MMPS ALWAYS\nMOVES TRANS(1)\n"
      "SPEED 10 MMPS\nMOVES TRANS(2)\nSIGNAL 4\nMOVES TRANS(3)\nBREAK\nSIGNAL -4\nDELAY 2\n.END\n",
      "x", nullptr);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_TRUE(read->strays.empty());
  ASSERT_EQ(read->moves.size(), 3U);
  EXPECT_EQ(read->moves[0].speed, 100.0);
  EXPECT_EQ(read->moves[1].speed, 10.0);
  EXPECT_EQ(read->moves[2].speed, 100.0);  // without ALWAYS a speed is that of one move
  EXPECT_EQ(read->moves[2].wait, 2.0);
  ASSERT_EQ(read->signals.size(), 2U);
  EXPECT_EQ(read->signals[0].afterMoves, 1U);
  EXPECT_EQ(read->signals[1].afterMoves, 3U);
  ASSERT_TRUE(read->toolShift);
  EXPECT_EQ(read->toolShift->z(), 180.0);
  EXPECT_EQ(read->base[2], 5.0);
}

TEST(VplusReader, ToolsAndBasesMayNotChangeBetweenMoves) {
  const auto strays = [](const std::string& lines) {
    const auto read = vplus::readProgram(".PROGRAM a()\n" + lines + "\n.END\n", "x", nullptr);
    EXPECT_TRUE(read.ok());
    return read->strays.size();
  };
  EXPECT_EQ(strays("TOOL TRANS(1)\nMOVE TRANS(1)\nTOOL TRANS(1)"), 0U);
  EXPECT_EQ(strays("TOOL TRANS(1)\nMOVE TRANS(1)\nTOOL TRANS(2)"), 1U);
  EXPECT_EQ(strays("MOVE TRANS(1)\nTOOL"), 1U);
  EXPECT_EQ(strays("TOOL unknown\nMOVE TRANS(1)"), 1U);
  EXPECT_EQ(strays("BASE 1\nMOVE TRANS(1)\nBASE 1"), 0U);
  EXPECT_EQ(strays("MOVE TRANS(1)\nBASE 1"), 1U);
  EXPECT_EQ(strays("BASE unknown\nMOVE TRANS(1)"), 1U);
}

TEST(VplusReader, RefusesTheRest) {
  EXPECT_THAT(refusal("MOVS f"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("JMOVE f"), HasSubstr("`F` stands where `=` is expected"));
  EXPECT_THAT(refusal("MOVE TRANS(1,2,3,4,5,6,7)"), HasSubstr("behind 6 values"));
  EXPECT_THAT(refusal("MOVE TRANS(1,2,3,0,181,0)"), HasSubstr("the pitch is 181"));
  EXPECT_THAT(refusal("SPEED 0 MMPS"), HasSubstr("the speed is 0"));
  EXPECT_THAT(refusal("SIGNAL 0"), HasSubstr("there is no output 0"));
  EXPECT_THAT(refusal("SIGNAL 600"), HasSubstr("there is no output 600"));
  EXPECT_THAT(refusal("a.name.too.long.x = 1"), HasSubstr("17 characters; 15 count"));
  EXPECT_THAT(refusal("BREAK\nAUTO x"), HasSubstr("declarations stand before"));
  EXPECT_THAT(refusal("IF x THEN"), HasSubstr("IF is not closed by END"));
  EXPECT_THAT(refusal("END"), HasSubstr("END without"));
  EXPECT_THAT(refusal("x = 1\nMOVE x"), HasSubstr("`X` is a number, and a location is expected"));
  EXPECT_THAT(refusal("SET f = NULL\nf = 1"),
              HasSubstr("`F` is a location and cannot become a number"));
  EXPECT_THAT(refusal("SET p = SHIFT(q BY 1,2,3,4)"), HasSubstr("`,` stands where `)`"));
  EXPECT_THAT(refusal("BASE 1,2,3,4,5"), HasSubstr("BASE takes 4 values"));
  EXPECT_THAT(refusal("IF x THEN\nELSE\nELSE\nEND"), HasSubstr("a second ELSE"));
  EXPECT_THAT(refusal("WHILE x DO\nELSE\nEND"), HasSubstr("ELSE outside IF"));
  EXPECT_THAT(refusal("10 BREAK\n10 BREAK"), HasSubstr("the label 10 stands twice"));
  EXPECT_THAT(refusal("DURATION -1"), HasSubstr("the time is -1"));
  EXPECT_THAT(refusal("DELAY -1"), HasSubstr("the time is -1"));
  EXPECT_THAT(refusal("BREAK 3"), HasSubstr("`3` stands where the end of the line"));
  EXPECT_THAT(refusal("MOVE f:"), HasSubstr("the end of the line stands where a location"));
  EXPECT_THAT(refusal("x = " + std::string(200, '(')), HasSubstr("148"));
  EXPECT_THAT(refusal("TYPE \"open"), HasSubstr("line 2"));
  EXPECT_THAT(refusal("x = 1\x07"), HasSubstr("not printable"));
  EXPECT_FALSE(vplus::readProgram("", "x", nullptr).ok());
  EXPECT_FALSE(vplus::readProgram(".PROGRAM a()\n", "x", nullptr).ok());
  EXPECT_FALSE(vplus::readProgram(".PROGRAM a()\n.END\nBREAK\n", "x", nullptr).ok());
}

}  // namespace
}  // namespace arelem::test
