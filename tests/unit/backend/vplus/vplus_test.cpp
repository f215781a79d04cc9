#include <cmath>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/robot/machine.h"
#include "backend/vplus/name.h"
#include "backend/vplus/reader.h"
#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

cl::Motion pose(std::vector<double> numbers) {
  cl::Motion m;
  m.withAxis = numbers.size() >= 6;
  m.withSide = numbers.size() == 9;
  m.coordinates = std::move(numbers);
  return m;
}
cl::Post post(Word word, std::vector<cl::Value> values = {}) {
  return {word, "", std::move(values)};
}

std::string program(const std::vector<cl::Record>& records,
                    const robot::Machine* machine = nullptr,
                    std::vector<std::string>* codes = nullptr) {
  backend::Context context;
  context.machine = machine;
  CollectingSink sink;
  std::string text = written("vplus", records, context, sink);
  for (const Diagnostic& d : sink.all()) {
    if (codes != nullptr) {
      codes->emplace_back(d.kind().code);
    } else {
      ADD_FAILURE() << d.message;
    }
  }
  return text;
}

std::vector<cl::Record> stroke() {
  return {record(1, cl::Text{Word::PARTNO, " Stroke 1"}),
          record(2, post(Word::RAPID)),
          record(2, pose({100, 0, 200, 0, 0, 1, 1, 0, 0})),
          record(2, post(Word::SPRAY, {Word::ON, 3.0})),
          record(2, post(Word::FEDRAT, {250.0, Word::MMPS})),
          record(2, pose({100, 400, 200, 0, 0, 1, 0, 1, 0})),
          record(2, post(Word::SPRAY, {Word::OFF, 3.0})),
          record(3, cl::Fini{})};
}

TEST(Vplus, AStrokeIsACompleteProgram) {
  EXPECT_EQ(program(stroke()),
            ".PROGRAM stroke.1()\r\n"
            "  ; made by arelem from CL data\r\n"
            "  AUTO f\r\n"
            "  SET f = TRANS(0.000, 0.000, 0.000, 0.000, 0.000, 0.000)\r\n"
            "  ACCEL 100, 100\r\n"
            "  ; Stroke 1\r\n"
            "  SPEED 500.000, 100 MMPS ALWAYS\r\n"
            "  MOVE f:TRANS(100.000, 0.000, 200.000, 0.000, 180.000, 180.000)\r\n"
            "  BREAK\r\n"
            "  SIGNAL 3\r\n"
            "  SPEED 250.000, 100 MMPS ALWAYS\r\n"
            "  MOVES f:TRANS(100.000, 400.000, 200.000, 0.000, 180.000, 90.000)\r\n"
            "  BREAK\r\n"
            "  SIGNAL -3\r\n"
            "  BREAK\r\n"
            "  RETURN\r\n"
            ".END\r\n");
}

/// With an approach rapid moves go up, across and down along the tool.
TEST(Vplus, RapidMovesApproachAndDepart) {
  robot::Machine machine;
  machine.vplus.approach = 50.0;
  machine.vplus.tool = {0.0, 0.0, 180.0, 0.0, 0.0, 90.0};
  std::vector<cl::Record> records = stroke();
  records.pop_back();
  for (cl::Record& record : stroke()) {
    records.push_back(std::move(record));
  }
  const std::string text = program(records, &machine);
  EXPECT_THAT(text, HasSubstr("  TOOL TRANS(0.000, 0.000, 180.000, 0.000, 0.000, 90.000)\r\n"));
  EXPECT_THAT(
      text,
      HasSubstr("  APPRO f:TRANS(100.000, 0.000, 200.000, 0.000, 180.000, 180.000), 50.000\r\n"
                "  MOVES f:TRANS(100.000, 0.000, 200.000, 0.000, 180.000, 180.000)\r\n"));
  EXPECT_THAT(
      text,
      HasSubstr("  SIGNAL -3\r\n"
                "  ; Stroke 1\r\n"
                "  SPEED 500.000, 100 MMPS ALWAYS\r\n"
                "  DEPARTS 50.000\r\n"
                "  APPROS f:TRANS(100.000, 0.000, 200.000, 0.000, 180.000, 180.000), 50.000\r\n"
                "  MOVES f:TRANS(100.000, 0.000, 200.000, 0.000, 180.000, 180.000)\r\n"));
  EXPECT_THAT(text, HasSubstr("  SIGNAL -3\r\n  DEPARTS 50.000\r\n  BREAK\r\n  RETURN\r\n"));
  auto read = vplus::readProgram(text, "p.v2", nullptr);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->moves.size(), 4U);  // places over others are no locations of the CL
}

/// On the fly the output changes as the tool departs.
TEST(Vplus, DepartsSwitchOnTheFly) {
  robot::Machine machine;
  machine.vplus.approach = 50.0;
  machine.vplus.onTheFly = true;
  EXPECT_THAT(program(stroke(), &machine),
              HasSubstr("  DEPARTS 50.000\r\n  SIGNAL -3\r\n  BREAK\r\n"));
}

TEST(Vplus, OnTheFlySignalsFollowTheMoveThatBegins) {
  robot::Machine machine;
  machine.vplus.onTheFly = true;
  machine.vplus.crlf = false;
  const std::string text = program(stroke(), &machine);
  EXPECT_THAT(text, HasSubstr("180.000, 90.000)\n  SIGNAL 3\n  BREAK\n  SIGNAL -3\n"));
}

TEST(Vplus, ReadsBackWhatItWrites) {
  auto read = vplus::readProgram(program(stroke()), "x.v2", nullptr);
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(read->name, "STROKE.1");
  ASSERT_EQ(read->moves.size(), 2U);
  EXPECT_LT((read->moves[1].pose.point - Vec3(100, 400, 200)).norm(), 1e-9);
  EXPECT_LT((read->moves[1].pose.axis - Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((*read->moves[1].pose.side - Vec3::UnitY()).norm(), 1e-9);
  EXPECT_EQ(read->moves[1].speed, 250.0);
  EXPECT_TRUE(read->moves[1].straight);
  ASSERT_EQ(read->signals.size(), 2U);
  EXPECT_EQ(read->signals[0].afterMoves, 1U);
  EXPECT_TRUE(read->signals[0].on);
  EXPECT_TRUE(read->warnings.empty());
}

TEST(Vplus, FeedsAreSpeeds) {
  const auto speed = [](std::vector<cl::Value> values, Word unit = Word::MM) {
    const std::string text =
        program({record(1, cl::Units{unit}), record(2, post(Word::FEDRAT, std::move(values))),
                 record(3, pose({1, 0, 0}))});
    const std::size_t at = text.find("SPEED ");
    return text.substr(at, text.find(',', at) - at);
  };
  EXPECT_EQ(speed({600.0}), "SPEED 10.000");               // mm a minute
  EXPECT_EQ(speed({60.0}, Word::INCHES), "SPEED 25.400");  // in a minute
  EXPECT_EQ(speed({60.0, Word::IPM}), "SPEED 25.400");
  EXPECT_EQ(speed({600.0, Word::MMPM}, Word::INCHES), "SPEED 10.000");
  EXPECT_EQ(speed({12.5, Word::MMPS}), "SPEED 12.500");
  std::vector<std::string> codes;
  program({record(1, post(Word::FEDRAT, {0.2, Word::MMPR})),
           record(2, post(Word::COOLNT, {Word::ON})), record(2, post(Word::COOLNT, {Word::OFF}))},
          nullptr, &codes);
  EXPECT_THAT(codes, ElementsAre("E0621", "W0620"));
}

TEST(Vplus, TiltGoesToItsOwnAxis) {
  robot::Machine machine;
  machine.tilt.emplace();
  const double b = 10.0 * 3.14159265358979 / 180.0;
  const std::vector<cl::Record> records = {
      record(1, pose({0, 0, 300, std::sin(b), 0, std::cos(b), std::cos(b), 0, -std::sin(b)}))};
  const std::string text = program(records, &machine);
  EXPECT_THAT(text, HasSubstr("BITS 33, 8 = 50\r\n"));
  EXPECT_THAT(text, HasSubstr("TRANS(0.000, 0.000, 300.000, 0.000, 180.000, 180.000)"));
  auto read = vplus::readProgram(text, "x", &*machine.tilt);
  ASSERT_TRUE(read.ok());
  EXPECT_LT((read->moves[0].pose.axis - Vec3(std::sin(b), 0, std::cos(b))).norm(), 1e-9);
  machine.tilt->most = 5.0;
  std::vector<std::string> codes;
  program(records, &machine, &codes);
  EXPECT_THAT(codes, ElementsAre("E0665"));
}

cl::Record tilted(double x, double degrees) {
  const double b = degrees * 3.14159265358979 / 180.0;
  return record(1, pose({x, 0, 300, std::sin(b), 0, std::cos(b), std::cos(b), 0, -std::sin(b)}));
}

/// BITS run as the move before them begins: behind MOVES they turn the axis during that move.
TEST(Vplus, TiltTurnsDuringTheMoveToItsLocation) {
  robot::Machine machine;
  machine.tilt.emplace();
  machine.vplus.crlf = false;
  const std::string text =
      program({record(1, post(Word::FEDRAT, {100.0, Word::MMPS})), tilted(0, 0), tilted(100, 10),
               tilted(200, 10), tilted(300, -4)},
              &machine);
  const std::string second = "  MOVES f:TRANS(100.000, 0.000, 300.000, 0.000, 180.000, 180.000)\n";
  const std::string third = "  MOVES f:TRANS(200.000, 0.000, 300.000, 0.000, 180.000, 180.000)\n";
  EXPECT_THAT(text, HasSubstr(second + "  BITS 33, 8 = 50\n" + third + "  MOVES"));
  const auto leanOf = [&](const std::string& from, std::size_t move) {
    auto read = vplus::readProgram(from, "x", &*machine.tilt);
    EXPECT_TRUE(read.ok());
    return read->moves.at(move).pose.axis.x();
  };
  EXPECT_NEAR(leanOf(text, 0), 0.0, 1e-9);
  EXPECT_NEAR(leanOf(text, 1), 0.17365, 1e-5);  // sin 10
  EXPECT_NEAR(leanOf(text, 3), -0.06976, 1e-5);
  // One move early: the reader sees the move before lean.
  std::string early = text;
  early.erase(early.find("  BITS 33, 8 = 50\n"), 18);
  early.insert(early.find(second), "  BITS 33, 8 = 50\n");
  EXPECT_NEAR(leanOf(early, 0), 0.17365, 1e-5);
  // Behind BREAK the robot stands already: the tilt is that of the moves to come.
  early.insert(early.find("  BITS 33, 8 = 50\n"), "  BREAK\n");
  EXPECT_NEAR(leanOf(early, 0), 0.0, 1e-9);
}

/// The robot stands at DELAY and PAUSE: the gun is not to spray there.
TEST(Vplus, TheGunIsClosedBeforeTheRobotWaits) {
  robot::Machine machine;
  machine.vplus.onTheFly = true;
  machine.vplus.crlf = false;
  for (const auto& [word, wanted] :
       {std::pair{post(Word::DELAY, {2.0}), "  BREAK\n  SIGNAL -3\n  DELAY 2.000\n"},
        std::pair{post(Word::STOP), "  BREAK\n  SIGNAL -3\n  PAUSE\n"}}) {
    std::vector<cl::Record> records = stroke();
    records.insert(records.end() - 1, record(3, word));
    EXPECT_THAT(program(records, &machine), HasSubstr(wanted));
  }
}

TEST(Vplus, WhatItsReaderRefusesIsNotWritten) {
  const auto codes = [](std::vector<cl::Record> records) {
    records.insert(records.begin(), record(1, post(Word::FEDRAT, {100.0, Word::MMPS})));
    std::vector<std::string> found;
    program(records, nullptr, &found);
    return found;
  };
  EXPECT_THAT(codes({record(2, post(Word::SPRAY, {Word::ON, 600.0}))}), ElementsAre("E0624"));
  EXPECT_THAT(codes({record(2, post(Word::SPRAY, {Word::ON, 1.5}))}), ElementsAre("E0624"));
  EXPECT_THAT(codes({record(2, post(Word::SPRAY, {Word::ON, 2001.0}))}), ElementsAre());
  EXPECT_THAT(codes({record(2, post(Word::DELAY, {-2.0}))}), ElementsAre("E0625"));
  EXPECT_THAT(codes({record(2, post(Word::DELAY, {2.0, Word::REV}))}), ElementsAre("E0625"));
  EXPECT_THAT(codes({record(2, pose({1e50, 1e50, 1e50}))}), ElementsAre("E0623"));
}

TEST(Vplus, ACutWithoutAFeedIsRefused) {
  std::vector<std::string> codes;
  program({record(1, pose({0, 0, 0})), record(2, post(Word::RAPID)), record(2, pose({5, 0, 0}))});
  program({record(1, pose({0, 0, 0})), record(2, pose({5, 0, 0}))}, nullptr, &codes);
  EXPECT_THAT(codes, ElementsAre("E0671"));
}

/// The lines of pathS.c: inches are mm, and what they cannot say is told.
TEST(Vplus, LinesOfTheSourceKeepUnitsAndTellWhatTheyLack) {
  robot::Machine machine;
  machine.vplus.format = robot::VplusStyle::Format::pathS;
  std::vector<std::string> codes;
  const std::string text = program(
      {record(1, cl::Units{Word::INCHES}), record(1, post(Word::FEDRAT, {60.0})),
       record(2, pose({1, 2, 3, 0, 0, 1, 1, 0, 0})), record(3, post(Word::STOP)), tilted(10, 5)},
      &machine, &codes);
  EXPECT_THAT(text, HasSubstr("move trans( 25.4, 50.8,( 76.2+offset),0,180,  0.0)\n"
                              "speed ( 25.4*scale), rotate MMPS \n"));
  EXPECT_THAT(codes, ElementsAre("W0620", "W0620"));
  codes.clear();
  program({record(2, pose({1, 2, 3, 0, 0, 1, 1, 0, 0}))}, &machine, &codes);
  EXPECT_THAT(codes, ElementsAre("E0671"));
}

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
       record(6, post(Word::CYCLE, {Word::OFF})), record(7, post(Word::FEDRAT, {600.0})),
       record(8, pose({20, 5, 30}))},
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
    program({record(1, post(Word::FEDRAT, {9.0})), record(2, cycle)}, nullptr, &codes);
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

/// A roll of half a turn is written one way, however its sine was rounded.
TEST(Vplus, HalfATurnHasOneSign) {
  for (const double side : {1e-16, -1e-16, 4e-6, -4e-6}) {
    const std::string text = program({record(1, pose({0, 0, 0, 0, 0, 1, 1, side, 0}))});
    EXPECT_THAT(text, HasSubstr("0.000, 180.000, 180.000)")) << side;
  }
}

TEST(Vplus, LimitsOfTheRobotAreKept) {
  robot::Machine machine;
  machine.scara.emplace();
  machine.speed = 200.0;
  std::vector<std::string> codes;
  program({record(1, post(Word::FEDRAT, {100.0, Word::MMPS})), record(1, pose({2000, 0, 100})),
           record(2, pose({600, 0, 900})), record(3, pose({600, 0, 100, 0.6, 0, 0.8})),
           record(4, post(Word::FEDRAT, {250.0, Word::MMPS})), record(5, pose({600, 0, 100}))},
          &machine, &codes);
  // Too far, too high, leaning, too fast.
  EXPECT_THAT(codes, ElementsAre("E0660", "E0661", "E0664", "E0666"));
}

TEST(Vplus, NamesOfPrograms) {
  EXPECT_EQ(vplus::programName(" SCHOOL XING  24"), "school.xing.24");
  EXPECT_EQ(vplus::programName("4711"), "p.4711");
  EXPECT_EQ(vplus::programName("STOP"), "p.stop");
  EXPECT_EQ(vplus::programName("A VERY LONG PART NAME"), "a.very.long.par");
  EXPECT_EQ(vplus::programName("??"), "part");
}

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

/// Damaged programs are read or refused.
TEST(VplusReader, SurvivesRandomDamage) {
  const std::string good = program(stroke());
  std::mt19937 random(11);
  for (int i = 0; i < 2000; ++i) {
    std::string text = good;
    for (int k = 0; k < 4; ++k) {
      text[random() % text.size()] = static_cast<char>(random() % 128);
    }
    const auto read = vplus::readProgram(text, "x", nullptr);
    EXPECT_TRUE(read.ok() || !read.failure().message.empty());
  }
}

}  // namespace
}  // namespace arelem::test
