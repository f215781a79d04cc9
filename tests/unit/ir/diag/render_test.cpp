#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "ir/diag/display_text.h"
#include "ir/diag/excerpt.h"
#include "ir/diag/files.h"
#include "ir/diag/frontend.h"
#include "ir/diag/geometry.h"
#include "ir/diag/interpret.h"
#include "ir/diag/reading_order.h"
#include "ir/diag/render_json.h"
#include "ir/diag/render_text.h"

namespace arelem {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct Source {
  SourceMap map;
  BufferId id;
  explicit Source(std::string text) : id(map.add("job.apt", std::move(text))) {}
  [[nodiscard]] Span find(std::string_view piece) const {
    const auto at = map.text(id).find(piece);
    return {id, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(piece.size())};
  }
  [[nodiscard]] std::string render(const Diagnostic& d, const TextRendering& how = {}) const {
    std::ostringstream out;
    renderText(out, d, map, how);
    return out.str();
  }
};

TEST(RenderText, ShowsPlaceCodeSourceCaretAndOldNumber) {
  const Source s("PARTNO X\nL1=LINE/P1,P2\nFINI\n");
  EXPECT_EQ(s.render(diagnose(s.find("P2"), diag::UndefinedSymbol, "P2")),
            "job.apt:2:12: error[E0201]: `P2` is not defined\n"
            "    2 | L1=LINE/P1,P2\n"
            "      |            ^^\n"
            "   [old APT number: 101]\n");
}

TEST(RenderText, GnuLineOnlyWhenNoExcerptIsWanted) {
  const Source s("A=B\n");
  TextRendering how;
  how.excerpt = false;
  EXPECT_EQ(s.render(diagnose(s.find("B"), diag::UndefinedSymbol, "B"), how),
            "job.apt:1:3: error[E0201]: `B` is not defined\n");
}

TEST(RenderText, LabelsOnTheSameAndOnOtherLines) {
  const Source s("P1=POINT/0,0\n\n\nL1=LINE/P1,P2\n");
  const auto text = s.render(diagnose(s.find("P2"), diag::UndefinedSymbol, "P2")
                                 .label(s.find("L1"), "for this line")
                                 .label(s.find("P1"), "the other point")
                                 .withHelp("define it first"));
  EXPECT_EQ(text,
            "job.apt:4:12: error[E0201]: `P2` is not defined\n"
            "    1 | P1=POINT/0,0\n"
            "      | -- the other point\n"
            "  ... |\n"
            "    4 | L1=LINE/P1,P2\n"
            "      | --         ^^\n"
            "      | for this line\n"
            "   help: define it first\n"
            "   [old APT number: 101]\n");
}

TEST(RenderText, StatementOverSeveralLinesIsMarkedAtBothEnds) {
  const Source s("  C=CIRCLE/1, $\n 2,\n  3\n");
  const auto text =
      s.render(diagnose(s.find("C=CIRCLE/1, $\n 2,\n  3"), diag::NoSuchForm, "CIRCLE", "1,2,3"));
  EXPECT_THAT(text, HasSubstr("    1 |   C=CIRCLE/1, $\n"
                              "      |   ^^^^^^^^^^^^^\n"
                              "  ... |\n"
                              "    3 |   3\n"
                              "      |   ^\n"));
}

TEST(RenderText, TabsWideAndControlCharactersKeepTheCaretInPlace) {
  const Source s("\tÄ日\x1b=X\n");
  const auto text = s.render(diagnose(s.find("X"), diag::UndefinedSymbol, "X"));
  EXPECT_THAT(text, HasSubstr("job.apt:1:6: "));
  EXPECT_THAT(text, HasSubstr("    1 |         Ä日\\x1B=X\n"  // 8 blanks, 1, 2 and 4 columns, `=`
                              "      |                 ^\n"));
}

TEST(RenderText, HostileTextReachesTheTerminalSpeltOut) {
  const Source s("A\n");
  const auto text =
      s.render(diagnose(s.find("A"), diag::UndefinedSymbol, "A\x1b[2J\r\n\xE4\xE2\x80\xAE"));
  EXPECT_THAT(text, HasSubstr("`A\\x1B[2J\\x0D\\x0A\\xE4<U+202E>` is not defined"));
}

TEST(RenderText, ManyCallsAreShortened) {
  const Source s("A=B\n");
  auto d = diagnose(s.find("B"), diag::UndefinedSymbol, "B");
  d.calledFrom.assign(9'990, s.find("A"));
  const auto text = s.render(d);
  EXPECT_THAT(text, HasSubstr("   called from job.apt:1:1\n   … 9980 more calls\n"));
}

TEST(RenderText, DiagnosticWithoutPlaceNamesTheProgram) {
  const Source s("");
  EXPECT_EQ(s.render(at(nowhere, fail(diag::InputUnreadable, "a.apt", "it is a folder"))),
            "arelem: error[E0701]: cannot read `a.apt`: it is a folder\n");
}

TEST(RenderText, ColorsOnlyWhenAsked) {
  const Source s("A=B\n");
  const auto d = diagnose(s.find("B"), diag::UndefinedSymbol, "B");
  TextRendering how;
  EXPECT_EQ(s.render(d, how).find('\033'), std::string::npos);
  how.color = true;
  EXPECT_NE(s.render(d, how).find("\033[1;31merror"), std::string::npos);
}

TEST(Excerpt, LongLineIsCutRoundThePlace) {
  const std::string line = std::string(300, 'a') + "XYZ" + std::string(300, 'b');
  const Excerpt shown = excerpt(line, {{300, 303, true, ""}}, 100);
  EXPECT_EQ(shown.source, "…" + std::string(33, 'a') + "XYZ" + std::string(64, 'b') + "…");
  EXPECT_THAT(shown.underlines, ElementsAre(std::string(34, ' ') + "^^^"));
}

TEST(Excerpt, LineOfAHundredMegabytesIsCheap) {
  std::string line(100'000'000, '1');
  line[50'000'000] = 'X';
  const Excerpt shown = excerpt(line, {{50'000'000, 50'000'001, true, ""}}, 100);
  EXPECT_LT(shown.source.size(), 120U);
  EXPECT_NE(shown.source.find('X'), std::string::npos);
}

TEST(Excerpt, EmptyMarkIsOneCaretAlsoBehindTheEnd) {
  const Excerpt shown = excerpt("A=", {{2, 2, true, ""}}, 100);
  EXPECT_EQ(shown.source, "A=");
  EXPECT_THAT(shown.underlines, ElementsAre("  ^"));
}

TEST(Utf8, OverlongSurrogateAndTruncatedFormsAreRefused) {
  for (const std::string_view bad :
       {"\xC0\x80", "\xED\xA0\x80", "\xE2\x82", "\xF4\x90\x80\x80", "\x80", "\xFF"}) {
    EXPECT_EQ(decodeUtf8(bad, 0).length, 0U);
  }
  EXPECT_EQ(decodeUtf8("\xF0\x9F\x98\x80", 0).value, U'\U0001F600');
}

TEST(RenderJson, IsOneObjectOnALineWithPositionsInThreeUnits) {
  const Source s("PARTNO\nÄ😀=B\n");
  std::ostringstream out;
  renderJson(out,
             diagnose(s.find("B"), diag::UndefinedSymbol, "B")
                 .label(s.find("PARTNO"), "a \"quote\"")
                 .note("n"),
             s.map);
  const std::string line = out.str();
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1);
  const auto json = nlohmann::json::parse(line);
  EXPECT_EQ(json["severity"], "error");
  EXPECT_EQ(json["code"], "E0201");
  EXPECT_EQ(json["legacy"], "101");
  EXPECT_EQ(json["file"], "job.apt");
  // Ä is 2 bytes and one UTF-16 unit, the face 4 bytes and two units.
  EXPECT_EQ(json["range"]["start"],
            nlohmann::json::parse(R"({"line":2,"column":4,"byte":14,"utf16":4})"));
  EXPECT_EQ(json["range"]["end"]["byte"], 15);
  EXPECT_EQ(json["related"][0]["message"], "a \"quote\"");
  EXPECT_EQ(json["notes"][0], "n");
  EXPECT_TRUE(json["help"].is_null());
  EXPECT_TRUE(json["fixes"].empty());
}

TEST(RenderJson, BadBytesBecomeReplacementCharacters) {
  EXPECT_EQ(nlohmann::json::parse(jsonString("a\xE4\x01\"\\")), "a\uFFFD\u0001\"\\");
}

TEST(ReadingOrder, MacrosStandAtTheirCallAndIncludesComeFirst) {
  SourceMap map;
  const BufferId main = map.add("main.apt", std::string(100, ' '));
  const BufferId included = map.add("lib.apt", std::string(100, ' '));
  const auto atOffset = [](BufferId b, std::uint32_t offset, std::string_view name) {
    return diagnose({b, offset, 1}, diag::UndefinedSymbol, name);
  };
  auto inMacro = atOffset(main, 5, "MACRO");
  inMacro.calledFrom = {{main, 8, 1}, {main, 50, 1}};
  const auto ordered = inReadingOrder({atOffset(main, 60, "LATE"), inMacro,
                                       atOffset(main, 20, "EARLY"), atOffset(included, 90, "LIB")},
                                      main);
  std::vector<std::string> texts;
  for (const auto& d : ordered) {
    texts.push_back(d.message);
  }
  EXPECT_THAT(texts, ElementsAre("`LIB` is not defined", "`EARLY` is not defined",
                                 "`MACRO` is not defined", "`LATE` is not defined"));
}

TEST(ReadingOrder, RepetitionIsCounted) {
  const auto d = diagnose({{0}, 3, 1}, diag::DivisionByZero);
  const auto ordered = inReadingOrder({d, d, d}, {0});
  ASSERT_EQ(ordered.size(), 1U);
  EXPECT_THAT(ordered[0].notes, ElementsAre("the same at this place 2 more times"));
}

}  // namespace
}  // namespace arelem
