#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/backend/writing.h"

namespace arelem::test {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> listing(const backend::Context& context,
                                 const std::vector<cl::Record>& records) {
  CollectingSink sink;
  return lines(written("listing", records, context, sink));
}

EntityPtr entity(EntityType type, std::vector<double> canon) {
  Entity e;
  e.type = type;
  e.canon = std::move(canon);
  return std::make_shared<const Entity>(std::move(e));
}

backend::ListingItem item(std::string name, EntityPtr value, int mode = 3) {
  backend::ListingItem i;
  i.isn = 4;
  i.mode = mode;
  i.name = std::move(name);
  i.entity = std::move(value);
  return i;
}

// The numbers are those of the manual's sample part (apt-language.md, 6.3).
TEST(Listing, RecordsAsClprntShowsThem) {
  cl::Motion from;
  from.kind = cl::Motion::Kind::from;
  from.name = "SP";
  from.coordinates = {0, 0, 0};
  cl::Motion go;
  go.name = "L1";
  go.coordinates = {3.875, 0, 0, 3.875, 8.051776695, 0};
  cl::Surface circle;
  circle.surface = {EntityType::circle, "C1", 0, {12, 10, 0, 0, 0, 1, 2}};
  const auto out = listing({}, {record(1, cl::Text{Word::PARTNO, " SAMPLE"}),
                                record(2, cl::Values{Word::INTOL, {0, 0, 0, 0.005}}),
                                record(3, cl::Post{Word::SPINDL, "", {2000.0, Word::CLW}}),
                                {4, "SP 0010", Span{}, from},
                                record(5, cl::Card{}),
                                record(6, circle),
                                record(6, go),
                                record(7, cl::Diagnostic{-1601}),
                                record(8, cl::Fini{})});
  EXPECT_THAT(
      out, ElementsAre(" * * * CL RECORDS * * *", "", " RECNO      1   CARD            ISN     1",
                       " PARTNO SAMPLE", "", " RECNO      3   CARD            ISN     2",
                       " INTOL /    0.000000    0.000000    0.000000    0.005000", "",
                       " RECNO      5   CARD            ISN     3", " SPINDL/   2000.0000     CLW",
                       "", " RECNO      7   CARD SP 0010    ISN     4", " *** FROM/     SP (   0)",
                       "      0.0000000      0.0000000      0.0000000", "",
                       " RECNO      9   CARD            ISN     5", "",
                       " RECNO     10   CARD            ISN     6",
                       " SURFACE DATA - CIRCLE ( DS ) **     C1 (   0) **", " CANON FORM",
                       "     12.0000000     10.0000000      0.0000000      0.0000000      "
                       "0.0000000      1.0000000",
                       "      2.0000000", " *** GO---/     L1 (   0)",
                       "      3.8750000      0.0000000      0.0000000",
                       "      3.8750000      8.0517767      0.0000000", "",
                       " RECNO     13   CARD            ISN     7", " *** WARNING -1601", "",
                       " RECNO     15   CARD            ISN     8", " ** FINI **"));
}

TEST(Listing, PrintedValues) {
  backend::Context context;
  context.printed.push_back(item("L1", entity(EntityType::line, {0, 1, 0, 2})));
  context.printed.push_back(item(
      "", entity(EntityType::matrix, {1, 0, 0, 5, 0, 1, 0, -0.0000001, 0, 0, 1, 123456789.5})));
  context.printed.push_back(item("A", nullptr));
  context.printed.back().scalar = -0.5;
  context.printed.push_back(item("P", entity(EntityType::point, {1, 2, 3}), 2));
  context.printed.push_back(item("P", entity(EntityType::point, {1, 2, 3}), 1));
  context.printed.push_back(item("Q", nullptr));
  context.printed.back().undefined = true;
  context.printed.push_back({});
  context.printed.back().isn = 5;
  context.printed.back().title = "A TITLE\x1b[2J";
  EXPECT_THAT(
      listing(context, {}),
      ElementsAre(
          " * * * SECTION 1 RESULTS * * *", "", " ISN     4",
          "     L1(   0)  LINE      4      0.000000      1.000000      0.000000      2.000000",
          " NESTED(   0)  MATRIX   12      1.000000      0.000000      0.000000      5.000000      "
          "0.000000"
          "      1.000000      0.000000",
          "                                0.000000      0.000000      0.000000      1.000000"
          " 123456789.500000",
          "      A(   0)  SCALAR    1     -0.500000", "      1.000000      2.000000      3.000000",
          "      P(   0)  ", "  3FF0000000000000  4000000000000000  4008000000000000",
          "      Q(   0)  UNDEFINED", "", " ISN     5", " A TITLE [2J", "",
          " * * * CL RECORDS * * *"));
}

TEST(Listing, SourceWithStatementNumbers) {
  SourceMap sources;
  const std::string text = "PARTNO X\n$$ NOTE\nRAPID, GOTO/1,2,3\nL1=LINE/$\n 1,2,3\t\x1b\nFINI";
  const BufferId buffer = sources.add("part.apt", text);
  ir::Program program;
  program.blocks.emplace_back();
  const auto statement = [&](std::uint32_t isn, std::string_view start) {
    ir::Statement s;
    s.isn = isn;
    s.span = {buffer, static_cast<std::uint32_t>(text.find(start)), 3};
    s.body = ir::Fini{};
    program.blocks[0].statements.push_back(s);
  };
  statement(1, "PARTNO");
  statement(3, "RAPID");
  statement(3, "GOTO");
  statement(4, "L1=");
  statement(5, "FINI");
  backend::Context context;
  context.sources = &sources;
  context.program = &program;
  EXPECT_THAT(
      listing(context, {}),
      ElementsAre(" * * * PART PROGRAM * * *", "", " part.apt", "", "    ISN   LINE",
                  "      1      1  PARTNO X", "             2  $$ NOTE",
                  "      3      3  RAPID, GOTO/1,2,3", "      4      4  L1=LINE/$",
                  "             5   1,2,3", "      5      6  FINI", "", " * * * CL RECORDS * * *"));
}

}  // namespace
}  // namespace arelem::test
