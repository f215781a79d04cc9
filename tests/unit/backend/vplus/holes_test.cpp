#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/vplus/reader.h"
#include "tests/unit/backend/vplus/programs.h"

namespace arelem::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// Two holes 8 deep with 90 mm a minute, from a place below the clearance of 2: up, across, down.
TEST(Vplus, CyclesAreWrittenMoveByMove) {
  robot::Machine machine;
  machine.vplus.crlf = false;
  const std::string text = program(
      {record(1, cl::Units{Word::MM}), record(1, post(Word::FEDRAT, {600.0})),
       record(2, pose({0, 0, 0})),
       record(3, post(Word::CYCLE, {Word::DRILL, 8.0, Word::MMPM, 90.0, 2.0, Word::DWELL, 0.5})),
       record(4, pose({10, 0, 0})), record(5, pose({20, 5, -1})),
       record(6, post(Word::CYCLE, {Word::OFF})), record(8, pose({20, 5, 30}))},
      &machine);
  const auto at = [](double x, double y, double z) {
    return fmt::format("  MOVES f:TRANS({:.3f}, {:.3f}, {:.3f}, 0.000, 180.000, 0.000)", x, y, z);
  };
  const std::string fast = "  SPEED 500.000, 100 MMPS ALWAYS";
  const std::string slow = "  SPEED 1.500, 100 MMPS ALWAYS";
  std::vector<std::string> lines = linesOf(text);
  lines.erase(lines.begin(), lines.begin() + 7);  // up to the move to the first place
  EXPECT_THAT(lines,
              ElementsAre(fast, at(0, 0, 2), at(10, 0, 2), slow, at(10, 0, -8), "  DELAY 0.500",
                          fast, at(10, 0, 2), at(20, 5, 2), at(20, 5, 1), slow, at(20, 5, -9),
                          "  DELAY 0.500", fast, at(20, 5, 1), "  SPEED 10.000, 100 MMPS ALWAYS",
                          at(20, 5, 30), "  BREAK", "  RETURN", ".END"));
}

/// Along a tool axis that leans: 0.6 and 0.8 of 5 mm.
TEST(Vplus, HolesGoAlongTheTool) {
  robot::Machine machine;
  machine.vplus.crlf = false;
  const std::string text =
      program({record(1, cl::Units{Word::MM}),
               record(2, post(Word::CYCLE, {Word::BORE, 10.0, Word::MMPM, 60.0, 5.0})),
               record(3, pose({0, 0, 0, 0.6, 0, 0.8}))},
              &machine);
  EXPECT_THAT(text, HasSubstr("MOVE f:TRANS(3.000, 0.000, 4.000,"));
  EXPECT_THAT(text,
              HasSubstr("  SPEED 1.000, 100 MMPS ALWAYS\n  MOVES f:TRANS(-6.000, 0.000, -8.000"));
  const auto read = vplus::readProgram(text, "x", nullptr);
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->moves.size(), 3U);
  EXPECT_EQ(read->moves[2].speed, 1.0);  // BORE feeds out
}

/// 0.2 mm a turn at 600 turns a minute are 2 mm/s; 3 turns take 0.3 s.
TEST(Vplus, TurnsOfASpindleCount) {
  std::vector<std::string> codes;
  const std::string text =
      program({record(1, cl::Units{Word::MM}), record(1, post(Word::SPINDL, {600.0, Word::CLW})),
               record(2, post(Word::FEDRAT, {0.2, Word::MMPR})), record(3, pose({0, 0, 0})),
               record(3, post(Word::DELAY, {3.0, Word::REV}))},
              nullptr, &codes);
  EXPECT_THAT(codes, ElementsAre("W0620"));  // the spindle itself is no part of a robot's program
  EXPECT_THAT(text, HasSubstr("SPEED 2.000, 100"));
  EXPECT_THAT(text, HasSubstr("DELAY 0.300"));
}

TEST(Vplus, CyclesWithoutMovesAreRefused) {
  for (const cl::Post& cycle : {post(Word::CYCLE, {Word::TAP, 9.0, Word::MMPM, 80.0, 2.0}),
                                post(Word::CYCLE, {Word::MILL, 9.0, Word::MMPM, 80.0, 2.0}),
                                post(Word::CYCLE, {Word::ON})}) {
    std::vector<std::string> codes;
    program({record(1, post(Word::FEDRAT, {9.0})), record(2, cycle), record(3, pose({0, 0, 0}))},
            nullptr, &codes);
    EXPECT_THAT(codes, ElementsAre("E0673"));
  }
  robot::Machine machine;
  machine.vplus.format = robot::VplusStyle::Format::pathB;
  std::vector<std::string> codes;
  program(
      {record(1, post(Word::CYCLE, {Word::DRILL, 8.0, Word::MMPM, 90.0, 2.0})),
       record(2, post(Word::CYCLE, {Word::OFF})), record(3, post(Word::SPRAY, {Word::ON, 1.0}))},
      &machine, &codes);
  EXPECT_THAT(codes, ElementsAre("E0673", "W0620"));
}

}  // namespace
}  // namespace arelem::test
