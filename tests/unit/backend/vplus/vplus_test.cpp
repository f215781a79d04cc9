#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/vplus/name.h"
#include "backend/vplus/reader.h"
#include "tests/unit/backend/vplus/programs.h"

namespace arelem::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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

/// A roll of half a turn is written one way, however its sine was rounded.
TEST(Vplus, HalfATurnHasOneSign) {
  for (const double side : {1e-16, -1e-16, 4e-6, -4e-6}) {
    const std::string text = program({record(1, pose({0, 0, 0, 0, 0, 1, 1, side, 0}))});
    EXPECT_THAT(text, HasSubstr("0.000, 180.000, 180.000)")) << side;
  }
}

/// A real of V+ has 24 bits, which are seven digits.
TEST(Vplus, NumbersHaveAtMostSevenDigits) {
  const std::string text =
      program({record(1, pose({9999.9994, -12345.678, 123456.78, 0, 0, 1})),
               record(1, post(Word::RAPID)), record(1, pose({-1234567.8, 1e-9, 0, 0, 0, 1}))});
  EXPECT_THAT(text, HasSubstr("TRANS(9999.999, -12345.68, 123456.8, "));
  EXPECT_THAT(text, HasSubstr("TRANS(-1234568, 0.000, 0.000, "));
}

TEST(Vplus, LongTextsGoOnInFurtherComments) {
  std::string words = "A";
  for (int i = 0; i < 40; ++i) {
    words += " word" + std::to_string(i);
  }
  const std::string text = program({record(1, cl::Text{Word::PPRINT, words})});
  std::string joined;
  for (std::size_t at = 0; (at = text.find("  ; ", at)) != std::string::npos; at += 4) {
    const std::size_t end = text.find('\r', at);
    EXPECT_LE(end - at, 80U);
    joined += text.substr(at + 3, end - at - 3);
  }
  EXPECT_THAT(joined, HasSubstr(words));
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

/// Damaged programs are refused with a place, or have moves that a robot could make.
TEST(Vplus, DamagedProgramsAreRefusedOrWhole) {
  const std::string good = program(stroke());
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = good;
    for (int k = 0; k < 4; ++k) {
      text[random() % text.size()] = static_cast<char>(random() % 128);
    }
    const auto read = vplus::readProgram(text, "x", nullptr);
    if (!read) {
      ++refused;
      EXPECT_EQ(read.failure().row->code, "E0630");
      EXPECT_THAT(read.failure().message, HasSubstr("`x`, line "));
      continue;
    }
    EXPECT_LE(read->moves.size(), 2U);
    for (const vplus::Move& move : read->moves) {
      EXPECT_TRUE(move.pose.point.allFinite());
      EXPECT_NEAR(move.pose.axis.norm(), 1.0, 1e-9);
      EXPECT_GE(move.speed, 0.0);
    }
  }
  EXPECT_GT(refused, 1000);  // four wrong characters in 700 seldom leave a program
  EXPECT_LT(refused, 2000);
}

}  // namespace
}  // namespace arelem::test
