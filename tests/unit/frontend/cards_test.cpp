// Cards and logical statements: language reference 1.1, 1.2, 1.6.
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

std::string pad(std::string text, std::size_t columns) {
  text.resize(columns, ' ');
  return text;
}

TEST(Cards, BlanksHaveNoMeaning) {
  EXPECT_EQ(statement("MY VAR 1 = 2 . 5", Dialect::native), "MYVAR1 = 2.5");
  EXPECT_EQ(statement("G O T O/ 1 , 2 ,\t3"), "GOTO/ 1, 2, 3");
}

TEST(Cards, LettersFoldToUpperCase) {
  EXPECT_EQ(statement("p1=point/1,2,3"), "P1 = POINT/ 1, 2, 3");
}

TEST(Cards, DollarContinuesAndDoubleDollarEnds) {
  EXPECT_EQ(statement("P1=POINT/1, $ rest of the card\n  2,3 $$ comment"), "P1 = POINT/ 1, 2, 3");
  EXPECT_EQ(statement("GOTO/1,2,3 $ $ blank between"), "GOTO/ 1, 2, 3");
}

TEST(Cards, DollarKeepsTheTokenOpen) {
  EXPECT_EQ(statement("P1=POI$\nNT/1$\n5,2,3"), "P1 = POINT/ 15, 2, 3");
}

TEST(Cards, ACardOfDollarAndCommentChains) {
  EXPECT_EQ(statement("P1=POINT/1,$\n$ only a comment\n2,3"), "P1 = POINT/ 1, 2, 3");
}

TEST(Cards, NothingToContinueIsAnError) {
  EXPECT_EQ(compileText("FINI\n")->codes(), "");
  EXPECT_EQ(compileText("A=1 $")->codes(), "E0113 E0289");
}

TEST(Cards, StatementsAreNumberedWithBlankAndCommentCardsButNotContinuations) {
  const auto c = compileText("PARTNO X\n\n$$ comment\nA=1 $\n +2\nB=2\nFINI\n");
  std::vector<std::uint32_t> isns;
  for (const auto& s : c->program.blocks[0].statements) {
    isns.push_back(s.isn);
  }
  EXPECT_EQ(isns, (std::vector<std::uint32_t>{1, 4, 5, 6}));
}

TEST(Cards, ColumnsAfter72AreIdentification) {
  const auto c =
      compileText(pad("A=1", 72) + "TEST0010\n" + pad("B=A+$", 72) + "TEST0020\n2\nFINI\n");
  ASSERT_EQ(c->codes(), "");
  EXPECT_EQ(c->block()[0], "A = 1  $$ TEST0010");
  EXPECT_EQ(c->block()[1], "B = (A + 2)  $$ TEST0020");
}

TEST(Cards, TextThatRunsAcrossColumn72StaysText) {
  const std::string line =
      "GOTO/" + std::string(20, ' ') + "1.000000,2.000000," + std::string(25, ' ') + "12345.6789";
  ASSERT_GT(line.size(), 72U);
  EXPECT_EQ(statement(line), "GOTO/ 1, 2, 12345.6789");
  EXPECT_EQ(statement(line, Dialect::cl), "GOTO/ 1, 2, 12345.6789");
}

TEST(Cards, Apt360CutsAtColumn72) {
  const auto c = compileText(pad("GOTO/1,2,3", 72) + "$%&\nFINI\n", Dialect::apt360);
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block()[0], "GOTO/ 1, 2, 3  $$ $%&");
}

TEST(Cards, TabsCountToTheNextStopOfEight) {
  const auto c = compileText("\t\t\t\t\t\t\t\tA=1     ABC00010\nFINI\n");
  EXPECT_EQ(c->codes(), "");
  EXPECT_EQ(c->block()[0], "A = 1  $$ ABC00010");
}

TEST(Cards, FixedFieldTextIsKeptFromColumn7) {
  EXPECT_EQ(statement("PARTNO  My part, $ no comment"), "PARTNO '  MY PART, $ NO COMMENT'");
  EXPECT_EQ(statement("PARTNO/ name"), "PARTNO '/ NAME'");
  EXPECT_EQ(statement("INSERTG0G49"), "INSERT 'G0G49'");
  EXPECT_EQ(statement("pprint***Text***", Dialect::native), "PPRINT '***Text***'");
}

TEST(Cards, RemarkIsNotExecuted) {
  EXPECT_TRUE(statements("remarkin APT $ ' (").empty());
}

TEST(Cards, FixedFieldTextEndsAtColumn72) {
  EXPECT_EQ(statement(pad("PPRINT TEXT", 72) + "ID000010"), "PPRINT ' TEXT'  $$ ID000010");
}

TEST(Cards, TitlesRightIsShiftedBy66) {
  EXPECT_EQ(statement("TITLES RIGHTX"), "TITLES '" + std::string(66, ' ') + "X'");
  EXPECT_EQ(statement("TITLES X"), "TITLES ' X'");
}

TEST(Cards, FixedFieldWordElsewhereIsAnError) {
  EXPECT_EQ(errors("  PPRINT TEXT"), "21");
  EXPECT_EQ(errors("A1) PPRINT/X"), "21");
  EXPECT_EQ(statement("  PPRINT/Text", Dialect::cl), "PPRINT 'Text'");
}

/// The slash of CL text is no part of the text; that of a fixed-field word of APT is.
TEST(Cards, TextsOfClBeginBehindTheSlash) {
  EXPECT_EQ(statement("INSERT / M08", Dialect::cl), "INSERT 'M08'");
  EXPECT_EQ(statement("INSERT/ /M08", Dialect::cl), "INSERT '/M08'");
  EXPECT_EQ(statement("INSERT/M08", Dialect::apt360), "INSERT '/M08'");
}

/// A dollar in a text of CL is a dollar; behind a comma or at the end of the line it continues.
TEST(Cards, ADollarInATextOfClLosesNoStatement) {
  const auto c = compileText("TPRINT/Tool 5$ cheap\nGOTO/1,2, $C\n3\nFINI\n", Dialect::cl);
  ASSERT_EQ(c->block().size(), 3U);
  EXPECT_NE(c->block()[0].find("cheap"), std::string::npos);
}

TEST(Cards, ContinuationCardsAreNotFixedField) {
  EXPECT_EQ(statement("PARTN2=3\nA=$\nPARTN2", Dialect::native), "A = PARTN2");
  EXPECT_NE(errors("A=$\nPPRINT 1"), "");
}

TEST(Cards, LineEndsOfEverySystem) {
  EXPECT_EQ(compileText("A=1\r\nB=2\r\nFINI\r\n")->block().size(), 3U);
  EXPECT_EQ(compileText("A=1\rB=2\rFINI\r")->block().size(), 3U);
  EXPECT_EQ(compileText("A=1\nB=2\nFINI")->block().size(), 3U);
  EXPECT_EQ(compileText("\xEF\xBB\xBF"
                        "A=1\nFINI\n")
                ->codes(),
            "");
  EXPECT_EQ(compileText("FINI\n\x1A")->codes(), "");
}

TEST(Cards, BadBytesAreReportedWithTheirOffset) {
  const auto nul = compileText(std::string("A=1\nB=\0002\nFINI\n", 14));
  EXPECT_EQ(nul->codes(), "E0102 E0101");
  EXPECT_EQ(nul->sink.all()[0].at.begin, 6U);
  const auto latin = compileText("PARTNO caf\xE9\nFINI\n");
  EXPECT_EQ(latin->codes(), "W0103");
  EXPECT_EQ(latin->sink.all()[0].at.begin, 10U);
  EXPECT_EQ(latin->block()[0], "PARTNO ' CAF\xC3\xA9'");
  EXPECT_EQ(compileText("$$ a\xE2\x80\xAE"
                        "b\nFINI\n")
                ->codes(),
            "W0104");
  EXPECT_EQ(errors("A=1;2"), "19");
}

TEST(Cards, EverythingAfterFiniIsUnread) {
  EXPECT_EQ(compileText("FINI\n\n$$ comment\n\n")->codes(), "");
  const auto c = compileText("FINI\nFOO BAR\n(((\n");
  EXPECT_EQ(c->codes(), "W0201");
  EXPECT_EQ(c->blamed(), "FOO BAR");
}

TEST(Cards, MissingFiniIsAnErrorExceptInClText) {
  EXPECT_EQ(compileText("A=1\n")->legacy(), "23");
  EXPECT_EQ(compileText("GOTO/1,2,3\n", Dialect::cl)->codes(), "");
  EXPECT_EQ(compileText("GOTO/1,2,3\n", Dialect::cl)->block().back(), "FINI");
}

TEST(Cards, LimitsOfLineAndFile) {
  Options options;
  options.limits.line = 100;
  const auto line =
      compileText("A=1\n" + std::string(200, 'X') + "\nFINI\n", Dialect::automatic, options);
  EXPECT_EQ(line->codes(), "E0820");
  EXPECT_EQ(line->block().size(), 2U);
  options.limits.bytes = 5;
  EXPECT_EQ(compileText("A=1\nFINI\n", Dialect::automatic, options)->codes(), "E0820");
}

TEST(Cards, ErrorsBeyondTheLimitAreCounted) {
  Options options;
  options.limits.errors = 3;
  std::string text;
  for (int i = 0; i < 10; ++i) {
    text += "A" + std::to_string(i) + "=U" + std::to_string(i) + "\n";
  }
  const auto c = compileText(text + "FINI\n", Dialect::automatic, options);
  EXPECT_EQ(c->codes(), "E0201 E0201 E0201 W0821");
  EXPECT_NE(c->sink.all().back().message.find("7 more"), std::string::npos);
}

}  // namespace
}  // namespace arelem::frontend
