// What may stand where: completion of statements, and the table of statement forms that it uses.
#include "frontend/complete/complete.h"

#include <cctype>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "ir/define/pattern.h"
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

const std::vector<KnownName> known = {
    {"A1", KnownName::Kind::scalar, {}},
    {"C1", KnownName::Kind::entity, EntityType::circle},
    {"L1", KnownName::Kind::entity, EntityType::line},
    {"LAB1", KnownName::Kind::label, {}},
    {"MAC1", KnownName::Kind::macro, {}},
    {"MX1", KnownName::Kind::entity, EntityType::matrix},
    {"P1", KnownName::Kind::entity, EntityType::point},
    {"PL1", KnownName::Kind::entity, EntityType::plane},
};

std::vector<std::string> after(std::string_view text) {
  return complete(text, known).candidates;
}

TEST(Complete, WordsThatTheFormsLetFollow) {
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,RAD"), ElementsAre("RADIUS"));
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,"), Contains("P1"));
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,"), Contains("TANTO"));
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,"), Not(Contains("CENTER")));
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,TANTO,"), ElementsAre("L1"));
  EXPECT_THAT(after("X=POINT/INTOF,L1,"), Contains("L1"));
  EXPECT_THAT(after("X=POINT/INTOF,L1,"), Not(Contains("C1")));  // XLARGE and its like are needed
  EXPECT_THAT(after("X=POINT/XLARGE,INTOF,L1,"), Contains("C1"));
}

TEST(Complete, WordsOfStatements) {
  EXPECT_THAT(after("COOLNT/"), ElementsAre("AIR", "FLOOD", "MIST", "OFF", "ON", "TAPKUL", "THRU"));
  EXPECT_THAT(after("units/m"), ElementsAre("MM"));
  EXPECT_THAT(after("TRACUT/"), ElementsAre("MX1", "NOMORE"));
  EXPECT_THAT(after("SMOOTH/.1,"),
              ElementsAre("ACCUR", "CLOSED", "METHOD", "PRECIS", "SHARE", "SPLINE"));
  EXPECT_THAT(after("PSIS/P"), ElementsAre("PL1"));
  EXPECT_THAT(after("GOTO/M"), IsEmpty());
}

TEST(Complete, WordsOfAMachineHaveTheirUsualParameters) {
  EXPECT_THAT(after("AIR/"), ElementsAre("OFF", "ON"));
  EXPECT_THAT(after("VTLAXS/"), ElementsAre("OFF", "ON"));
  EXPECT_THAT(after("VTLAXS/ON,"), ElementsAre("LEFT", "RIGHT"));
  EXPECT_THAT(after("ARCSLP/"),
              ElementsAre("AUTO", "CIRCUL", "LINCIR", "LINEAR", "OFF", "ON", "PARAB", "START"));
  EXPECT_THAT(after("MCHTOL/"), Contains("A1"));
  EXPECT_THAT(after("MCHTOL/"), Not(Contains("P1")));  // they take no entities
  EXPECT_THAT(after("RAPID/"), IsEmpty());
}

TEST(Complete, NumbersThatMeanSomething) {
  EXPECT_THAT(after("READ/"), ElementsAre("1", "2"));
  EXPECT_THAT(after("CUTTER/OPTION,"), ElementsAre("1", "2"));
}

TEST(Complete, CopiesAreOfTheSameType) {
  EXPECT_THAT(after("X=LINE/P1,"), Not(Contains("CANON")));
  EXPECT_THAT(after("X=LINE/L1,"), ElementsAre("CANON"));
  EXPECT_THAT(after("X=VECTOR/"), Not(Contains("C1")));
}

TEST(Complete, LabelsMacrosAndHeads) {
  EXPECT_THAT(after("JUMPTO/"), ElementsAre("LAB1"));
  EXPECT_THAT(after("CALL/"), ElementsAre("MAC1"));
  EXPECT_THAT(after("IF(A1)"), ElementsAre("LAB1"));
  const auto heads = after("");
  EXPECT_THAT(heads, Contains("GOTO/"));
  EXPECT_THAT(heads, Contains("CIRCLE/"));
  EXPECT_THAT(heads, Contains("RAPID"));
  EXPECT_THAT(heads, Not(Contains("XLARGE")));
  EXPECT_THAT(after("X=SIN"), ElementsAre("SINF("));
  EXPECT_THAT(after("X=2*"), Contains("A1"));
  EXPECT_THAT(after("X=2*"), Not(Contains("P1")));
}

TEST(Complete, WhatSharesAStatementWithAToolPosition) {
  for (const char* const text : {"TLRGT,", "RAPID,TLLFT,"}) {
    const auto found = after(text);
    EXPECT_THAT(found, Contains("GORGT/"));
    EXPECT_THAT(found, Contains("TLOFPS"));
    EXPECT_THAT(found, Not(Contains("POINT/")));
    EXPECT_THAT(found, Not(Contains("COOLNT/")));
    EXPECT_THAT(found, Not(Contains("P1")));
  }
}

TEST(Complete, NothingInTextsAndComments) {
  EXPECT_THAT(after("INCLUDE/'P"), IsEmpty());
  EXPECT_THAT(after("X=1 $$ P"), IsEmpty());
  EXPECT_THAT(after("X=POINT/1,2"), IsEmpty());
}

TEST(Complete, TellsWhatTheCandidatesReplace) {
  EXPECT_EQ(complete("X=CIRCLE/cen", known).begin, 9U);
  EXPECT_THAT(after("X=CIRCLE/cen"), ElementsAre("CENTER"));
  // A statement that goes on in the next line.
  EXPECT_THAT(after("X=CIRCLE/CENTER,P1,$\nRA"), ElementsAre("RADIUS"));
}

/// The words of a line as they are written, with the place where each begins.
std::vector<std::pair<std::size_t, std::string>> wordsOf(const std::string& line) {
  std::vector<std::pair<std::size_t, std::string>> words;
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && std::isalnum(static_cast<unsigned char>(line[end])) != 0) {
      ++end;
    }
    if (end > i && std::isalpha(static_cast<unsigned char>(line[i])) != 0) {
      words.emplace_back(i, line.substr(i, end - i));
    }
    i = std::max(end, i + 1);
  }
  return words;
}

/// NAME=TYPE/... on one line of plain capitals.
std::optional<EntityType> definedType(const std::string& line, std::string& name) {
  const std::size_t equals = line.find('=');
  const std::size_t slash = line.find('/');
  if (equals == std::string::npos || slash == std::string::npos || slash < equals) {
    return std::nullopt;
  }
  name = line.substr(0, equals);
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isupper(c) != 0 || std::isdigit(c) != 0;
  });
  const auto noun = findWord(line.substr(equals + 1, slash - equals - 1));
  return plain && noun ? entityType(*noun) : std::nullopt;
}

/// Every word of the language in the definitions of a correct program is offered where it stands.
std::size_t checkOffers(const std::string& text, const std::string& file) {
  std::istringstream in(text);
  std::vector<KnownName> names;
  std::string line;
  std::size_t checked = 0;
  while (std::getline(in, line)) {
    std::string name;
    const auto type = definedType(line, name);
    if (!type || line.find('$') != line.npos || line.find('\'') != line.npos) {
      continue;
    }
    for (const auto& [at, word] : wordsOf(line)) {
      const auto found = findWord(word);
      if (at <= line.find('=') || !found || row(*found).wordClass != WordClass::modifier) {
        continue;
      }
      const auto offered = complete(line.substr(0, at), names).candidates;
      EXPECT_THAT(offered, Contains(word)) << file << ": " << line.substr(0, at);
      ++checked;
    }
    names.push_back({name, KnownName::Kind::entity, *type});
  }
  return checked;
}

TEST(Complete, OffersWhatCorrectProgramsHave) {
  std::size_t checked = 0;
  const std::filesystem::path golden = std::filesystem::path(ARELEM_SOURCE_DIR) / "tests/golden";
  for (const std::string_view folder : {"geometry", "reference"}) {
    for (const auto& entry : std::filesystem::directory_iterator(golden / folder)) {
      const std::string text = readFile(entry.path());
      const auto program = compileText(text, Dialect::native);
      if (entry.path().extension() == ".apt" && program->sink.errors() == 0) {
        checked += checkOffers(text, entry.path().filename());
      }
    }
  }
  EXPECT_GT(checked, 300U);
}

TEST(StatementForms, EveryPatternCompilesAndEveryExampleIsCorrect) {
  const std::string before =
      "CUTTER/2\nINTOL/.01\nOUTTOL/.01\nP1=POINT/1,2,3\nL1=LINE/0,0,1,0\nL2=LINE/5,0,5,1\n"
      "PL1=PLANE/0,0,1,0\nFROM/0,-9,0\nINDEX/1\n";
  std::set<Word> seen;
  for (const StatementForm& form : statementForms()) {
    EXPECT_TRUE(seen.insert(form.word).second) << spell(form.word);
    std::string wrong;
    static_cast<void>(define::compile(form.pattern, &wrong));
    EXPECT_EQ(wrong, "") << spell(form.word);
    EXPECT_FALSE(form.meaning.empty()) << spell(form.word);
    if (form.example.empty()) {
      continue;
    }
    EXPECT_TRUE(form.example.starts_with(spell(form.word))) << form.example;
    const auto program =
        compileText(before + std::string(form.example) + "\nFINI\n", Dialect::native);
    EXPECT_EQ(program->sink.errors(), 0U) << form.example << ": " << program->codes();
    // The pattern offers each modifier of its own example.
    const std::string example(form.example);
    const std::vector<KnownName> names = {{"P1", KnownName::Kind::entity, EntityType::point},
                                          {"L1", KnownName::Kind::entity, EntityType::line},
                                          {"L2", KnownName::Kind::entity, EntityType::line},
                                          {"PL1", KnownName::Kind::entity, EntityType::plane}};
    for (const auto& [at, word] : wordsOf(example)) {
      const auto found = findWord(word);
      if (at > 0 && found && example.substr(0, at).find('\'') == std::string::npos) {
        EXPECT_THAT(complete(example.substr(0, at), names).candidates, Contains(word)) << example;
      }
    }
  }
}

}  // namespace
}  // namespace arelem::frontend
