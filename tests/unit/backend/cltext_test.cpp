#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using ::testing::ElementsAre;

cl::Motion motion(cl::Motion::Kind kind, std::vector<double> coordinates, bool withAxis = false) {
  cl::Motion m;
  m.kind = kind;
  m.withAxis = withAxis;
  m.coordinates = std::move(coordinates);
  return m;
}

std::vector<std::string> text(const std::vector<cl::Record>& records) {
  return lines(written("cl", records));
}

TEST(ClText, EveryStatement) {
  EXPECT_THAT(
      text({record(1, cl::Text{Word::PARTNO, " SPRAY TEST"}),
            record(2, cl::Post{Word::MACHIN, "", {std::string("GENER"), 1.0}}),
            record(3, cl::Units{Word::MM}), record(4, cl::Multax{true}),
            record(5, cl::Values{Word::INTOL, {0.01, 0.01, 0.01, 0.01}}),
            record(6, cl::Values{Word::CUTTER, {10.0, 0.5}}),
            record(7, cl::Post{Word::SPINDL, "", {1000.0, Word::RPM, Word::CLW}}),
            record(8, motion(cl::Motion::Kind::from, {0, 0, 50})),
            record(9, cl::Post{Word::RAPID, "", {}}),
            record(10, motion(cl::Motion::Kind::go, {1, 2.5, -3, 4, 5, 6})),
            record(10, motion(cl::Motion::Kind::continuation, {7, 8, 9})),
            record(11, cl::Post{Word::END, "CSI_SET", {15.0, std::string("ON/OFF,X")}}),
            record(12, cl::Post{Word::CLRSRF,
                                "",
                                {cl::SurfaceValue{EntityType::plane, "PL1", 0, {0, 0, 1, 0.1}}}}),
            record(13, cl::Fini{})}),
      ElementsAre("PARTNO / SPRAY TEST", "MACHIN / GENER, 1", "UNITS / MM", "MULTAX / ON",
                  "INTOL / 0.01, 0.01, 0.01, 0.01", "CUTTER / 10.0, 0.5", "SPINDL / 1000, RPM, CLW",
                  "FROM / 0.0, 0.0, 50.0", "RAPID", "GOTO / 1.0, 2.5, -3.0", "GOTO / 4.0, 5.0, 6.0",
                  "GOTO / 7.0, 8.0, 9.0", "CSI_SET / 15, ON OFF X",
                  "CLRSRF / (PLANE / 0.0, 0.0, 1.0, 0.1)", "FINI"));
}

TEST(ClText, WhatMustNotRunAgainIsAComment) {
  const cl::SurfaceValue shift{EntityType::matrix, "M1", 0, {1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0}};
  cl::Surface circle;
  circle.surface = {EntityType::circle, "C1", 0, {12, 10, 0, 0, 0, 1, 2}};
  EXPECT_THAT(text({record(1, cl::Post{Word::TRACUT, "", {shift}}),
                    record(2, cl::Post{Word::TRACUT, "", {Word::NOMORE}}),
                    record(3, cl::Post{Word::INDEX, "", {1.0}}), record(4, circle),
                    record(5, cl::Switch{Word::DNTCUT}), record(6, cl::Diagnostic{-1601}),
                    record(6, cl::Listing{true}), record(7, cl::Card{})}),
              ElementsAre("$$-> TRACUT / 1.0, 0.0, 0.0, 5.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, $",
                          "$$-> 0.0", "$$-> TRACUT / NOMORE", "$$-> INDEX / 1",
                          "$$-> CIRCLE / 12.0, 10.0, 0.0, 0.0, 0.0, 1.0, 2.0", "$$-> DNTCUT",
                          "$$-> DIAGNOSTIC / -1601", "$$-> CLPRNT / ON"));
}

TEST(ClText, LongStatementsContinueWithinTheColumns) {
  const std::vector<std::string> out =
      text({record(1, motion(cl::Motion::Kind::go,
                             {1.0 / 3, 2.0 / 3, 1e6 / 7, -1.0 / 3, -2.0 / 3, 0.1 + 0.2}, true))});
  EXPECT_THAT(out,
              ElementsAre("GOTO / 0.3333333333333333, 0.6666666666666666, 142857.14285714287, $",
                          "-0.3333333333333333, -0.6666666666666666, 0.30000000000000004"));
  for (int count = 1; count < 40; ++count) {
    std::vector<double> values(static_cast<std::size_t>(count), 1.0 / 3);
    for (const std::string& line :
         text({record(1, cl::Values{Word::CUTTER, values}),
               record(2, cl::Raw{15000, 1, std::vector<std::uint64_t>(values.size(), 7)})})) {
      EXPECT_LE(line.size(), 72U) << line;
    }
  }
}

TEST(ClText, FixedDecimals) {
  backend::Context context;
  context.decimals = 6;
  CollectingSink sink;
  EXPECT_EQ(written("cl",
                    {record(1, motion(cl::Motion::Kind::go, {1.0, -1e-9, 999999.9999996})),
                     record(2, cl::Post{Word::FEDRAT, "", {300.0, Word::IPM}})},
                    context, sink),
            "GOTO / 1.000000, 0.000000, 1000000.000000\nFEDRAT / 300, IPM\n");
}

TEST(ClText, HostileTextStaysOneStatement) {
  EXPECT_THAT(text({record(1, cl::Text{Word::PPRINT, " A\nGOTO / 1,2,3\r\x1b[2J$"}),
                    record(2, cl::Text{Word::INSERT, "COST $$ 5\xc3\xa4"}),
                    record(3, cl::Text{Word::PPRINT, "   "}),
                    record(4, cl::Post{Word::LOADTL, "", {std::string("A,B$\nEND")}})}),
              ElementsAre("PPRINT / A GOTO / 1,2,3  [2J#", "INSERT / COST $$ 5\xc3\xa4", "PPRINT",
                          "LOADTL / A B# END"));
}

TEST(ClText, SixtySixCharactersOfText) {
  const std::string full(66, 'X');
  EXPECT_THAT(text({record(1, cl::Text{Word::PPRINT, " " + full.substr(0, 65)}),
                    record(2, cl::Text{Word::PPRINT, full})}),
              ElementsAre("PPRINT/" + full.substr(0, 65), "PPRINT/" + full));
}

TEST(ClText, NumbersOutOfRangeAreErrorsAndNotWritten) {
  CollectingSink sink;
  const double infinite = std::numeric_limits<double>::infinity();
  const std::string out =
      written("cl",
              {record(4, motion(cl::Motion::Kind::go, {1, 2, std::nan("")})),
               record(5, motion(cl::Motion::Kind::go, {1e16, 0, 0})),
               record(6, cl::Post{Word::FEDRAT, "", {infinite}}), record(7, cl::Fini{})},
              backend::Context{}, sink);
  EXPECT_EQ(out, "FINI\n");
  ASSERT_EQ(sink.errors(), 1U);
  EXPECT_EQ(sink.all()[0].kind().code, "E0601");
}

}  // namespace
}  // namespace arelem::test
