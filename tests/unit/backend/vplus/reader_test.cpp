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

/// What is set without ALWAYS holds for one motion; .END returns.
TEST(VplusReader, KeepsWhatTheProgramDoes) {
  auto read = vplus::readProgram(
      ".PROGRAM a()\nSPEED 1, 50 IPS ALWAYS\nDURATION 2\nMOVE TRANS(1,2,3,0,180,0)\n"
      "MOVES TRANS(1,2,9,0,180,0)\nSIGNAL -1\n.END\n",
      "x", nullptr);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  ASSERT_EQ(read->events.size(), 4U);
  const auto setting = [&](std::size_t event, vplus::Setting which) {
    return read->events[event].manner->at(static_cast<std::size_t>(which));
  };
  EXPECT_EQ(read->events[0].what, "MOVE");
  EXPECT_DOUBLE_EQ(setting(0, vplus::Setting::toolSpeed), 25.4);
  EXPECT_EQ(setting(0, vplus::Setting::rotation), 50.0);
  EXPECT_EQ(setting(0, vplus::Setting::duration), 2.0);
  EXPECT_EQ(read->events[1].what, "MOVES");
  EXPECT_EQ(setting(1, vplus::Setting::duration), 0.0);
  EXPECT_EQ(vplus::shown(read->events[2]), "SIGNAL -1");
  EXPECT_EQ(read->events[2].line, 6U);
  EXPECT_EQ(read->events[3].what, "RETURN");
  const auto differs = vplus::difference(read->events[0], read->events[1]);
  ASSERT_TRUE(differs);
  EXPECT_EQ(differs->found, "MOVE");
  EXPECT_EQ(differs->wanted, "MOVES");
}

TEST(VplusReader, RefusesValuesWithoutMeaning) {
  for (const char* line : {"ACCEL -5, -5", "ACCEL (9) 100, 100", "COARSE -5", "SPEED 9, 0 MMPS",
                           "SPEED 0 MONITOR", "TRUE = 3"}) {
    auto read = vplus::readProgram(fmt::format(".PROGRAM a()\n{}\n.END\n", line), "x", nullptr);
    ASSERT_FALSE(read.ok()) << line;
    EXPECT_THAT(read.failure().message, HasSubstr("line 2")) << line;
  }
  auto twice = vplus::readProgram(".PROGRAM a()\n.END\n.PROGRAM A()\n.END\n", "x", nullptr);
  ASSERT_FALSE(twice.ok());
  EXPECT_THAT(twice.failure().message, HasSubstr("line 3"));
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
