#include "app/repl/highlight.h"

#include <random>
#include <regex>

#include <gtest/gtest.h>

namespace arelem::app::repl {
namespace {

const std::vector<frontend::KnownName> known = {
    {"L1", frontend::KnownName::Kind::entity, EntityType::line}};

std::string withoutColors(const std::string& text) {
  return std::regex_replace(text, std::regex("\033\\[[0-9;]*m"), "");
}

TEST(Highlight, WordsNamesNumbersTextsAndComments) {
  EXPECT_EQ(highlighted("p1=point/intof,l1,Q2", known),
            "p1=\033[1;34mpoint\033[0m/\033[34mintof\033[0m,\033[36ml1\033[0m,Q2");
  EXPECT_EQ(highlighted("A=12", known), "A=\033[33m12\033[0m");
  EXPECT_EQ(
      highlighted("INCLUDE/'a b'", known).find("\033[32m'a b'\033[0m"),
      highlighted("INCLUDE/'a b'", known).size() - std::string("\033[32m'a b'\033[0m").size());
  EXPECT_EQ(highlighted("A $$ POINT", known), "A \033[2m$$ POINT\033[0m");
  EXPECT_EQ(highlighted(":show L1", known), "\033[1;34m:show\033[0m L1");
  EXPECT_EQ(highlighted("", known), "");
}

TEST(Highlight, WithoutItsColorsItIsTheLine) {
  std::mt19937 random(8);
  const std::string letters = "GOTO/POINT 1.,'$=()L:*x";
  std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
  std::uniform_int_distribution<int> length(0, 40);
  for (int round = 0; round < 2000; ++round) {
    std::string line;
    for (int n = length(random); n > 0; --n) {
      line += letters[letter(random)];
    }
    EXPECT_EQ(withoutColors(highlighted(line, known)), line);
  }
}

}  // namespace
}  // namespace arelem::app::repl
