// A text cut into statements, as sessions and the formatter need it.
#include "frontend/outline.h"

#include <gtest/gtest.h>

namespace arelem::frontend {
namespace {

std::vector<OutlinedStatement> cut(std::string_view text) {
  return outline(text, Dialect::native, Limits());
}

TEST(Outline, StatementsHaveTheirLines) {
  const std::string text = "P1=POINT/1,$ first\n  2\n\n$$ only a comment\nGOTO/P1\n";
  std::vector<OutlinedStatement> found;
  for (const auto& s : cut(text)) {
    if (!s.text.empty()) {
      found.push_back(s);
    }
  }
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].text, "P1=POINT/1,2");
  EXPECT_EQ(text.substr(found[0].begin, found[0].end - found[0].begin),
            "P1=POINT/1,$ first\n  2\n");
  EXPECT_EQ(found[1].text, "GOTO/P1");
  EXPECT_EQ(found[1].end, text.size());
  EXPECT_EQ(found[1].head, Word::GOTO);
}

TEST(Outline, WhatAStatementIs) {
  const auto one = [](std::string_view text) { return cut(text).front(); };
  EXPECT_TRUE(one("CIRCLE/0,0,1\n").definition);
  EXPECT_FALSE(one("C1=CIRCLE/0,0,1\n").definition);
  EXPECT_TRUE(one("3*SINF(30)\n").expression);
  EXPECT_TRUE(one("A1\n").expression);
  EXPECT_TRUE(one("-A1+(2-1)\n").expression);
  EXPECT_FALSE(one("A1=3\n").expression);
  EXPECT_FALSE(one("GOTO/1,2\n").expression);
  EXPECT_EQ(one("L5) GOTO/1,2\n").head, Word::GOTO);
  EXPECT_EQ(one("PARTNO ANY TEXT\n").head, Word::PARTNO);
  EXPECT_EQ(one("FINI\n").head, Word::FINI);
}

TEST(Outline, NothingIsLost) {
  for (const std::string text : {"", "\n\n", "$$\n", "P1=POINT/1,$\n", "A=1", "A=1;B=2\nC=3"}) {
    std::uint32_t at = 0;
    for (const auto& s : cut(text)) {
      EXPECT_EQ(s.begin, at) << text;
      at = s.end;
    }
    EXPECT_EQ(at, text.size()) << text;
  }
}

}  // namespace
}  // namespace arelem::frontend
