#include "backend/vplus/reader.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arelem::test {
namespace {

using testing::HasSubstr;

TEST(VplusReader, KeepsFrameAndStrayMoves) {
  const auto read = [](const std::string& body) {
    auto made = vplus::readProgram(".PROGRAM a()\n" + body + ".END\n", "x", nullptr);
    EXPECT_TRUE(made.ok());
    return *std::move(made);
  };
  const std::string frame = "SET f = TRANS(999, 0, 0, 0, 0, 0)\n";
  const std::string at = "TRANS(1, 2, 3, 0, 180, 0)\n";
  const vplus::ProgramText good = read(frame + "MOVES f:" + at);
  EXPECT_EQ(good.frameShift.x(), 999.0);
  EXPECT_NEAR(good.moves.at(0).pose.point.x(), 1.0, 1e-9);
  EXPECT_NEAR(read(frame + "MOVES " + at).moves.at(0).pose.point.x(), -998.0, 1e-9);
  EXPECT_TRUE(good.strays.empty());
  EXPECT_EQ(read("MOVES HERE\n").strays.size(), 1U);
  EXPECT_EQ(read(frame + "APPROS f:TRANS(900, 900, 3, 0, 180, 0), 50\nMOVES f:" + at).strays.size(),
            1U);
  EXPECT_EQ(read("APPROS TRANS(1, 2, 3, 0, 180, 0), 50\n").strays.size(), 1U);
  EXPECT_EQ(read("DEPARTS -50\n").strays.size(), 1U);
}

/// A file may hold several programs: names are each one's own, moves those of the first.
TEST(VplusReader, ReadsSeveralPrograms) {
  auto read = vplus::readProgram(
      ".PROGRAM a()\nx = 1\nMOVE TRANS(1,2,3,0,180,0)\n.END\n\n.PROGRAM b()\n"
      "SET x = NULL\nMOVE x\nMOVE y\n.END\n",
      "x", nullptr);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->name, "A");
  EXPECT_EQ(read->moves.size(), 1U);
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_THAT(read->warnings[0].message, HasSubstr("`Y`"));
  auto cut = vplus::readProgram(".PROGRAM a()\n.END\n.PROGRAM b()\n", "x", nullptr);
  ASSERT_FALSE(cut.ok());
  EXPECT_THAT(cut.failure().message, HasSubstr("no .END"));
}

TEST(VplusReader, TellsWhatTheOperatorMustSet) {
  auto read = vplus::readProgram(
      ".PROGRAM a()\nGLOBAL offset\nspeed (5*scale) MMPS\nmove trans(1,2,offset)\n.END\n", "x",
      nullptr);
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->warnings.size(), 1U);
  EXPECT_THAT(read->warnings[0].message, HasSubstr("`SCALE`"));
  EXPECT_TRUE(read->moves.empty());
}

}  // namespace
}  // namespace arelem::test
