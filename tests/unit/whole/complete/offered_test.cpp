// What completion offers must lead somewhere: every word and name that is offered behind `WORD/`,
// and behind each first parameter, is finished by the tables to a whole statement, and Section 1
// must find no fault in the form of that.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "frontend/complete/complete.h"
#include "ir/define/continuation.h"
#include "ir/define/matcher.h"
#include "tests/unit/whole/interpret/section_one.h"

namespace arelem::test {
namespace {

using define::Symbol;
using frontend::KnownName;

/// One name of each type, and how it is defined.
struct Sample {
  std::string name;
  EntityType type;
  std::string definition;
};
const std::vector<Sample>& samples() {
  static const std::vector<Sample> all = {
      {"P1", EntityType::point, "P1=POINT/1,2,3"},
      {"L1", EntityType::line, "L1=LINE/0,0,1,0"},
      {"PL1", EntityType::plane, "PL1=PLANE/0,0,1,0"},
      {"C1", EntityType::circle, "C1=CIRCLE/0,0,4"},
      {"CY1", EntityType::cylinder, "CY1=CYLNDR/0,0,0,0,0,1,5"},
      {"E1", EntityType::ellipse, "E1=ELLIPS/CENTER,P1,4,2,10"},
      {"CO1", EntityType::cone, "CO1=CONE/CANON,0,0,0,0,0,1,.5"},
      {"V1", EntityType::vector, "V1=VECTOR/1,0,0"},
      {"MX1", EntityType::matrix, "MX1=MATRIX/TRANSL,1,2,3"},
      {"SP1", EntityType::sphere, "SP1=SPHERE/0,0,0,9"},
      {"TC1", EntityType::tabulatedCylinder, "TC1=TABCYL/NOZ,SPLINE,0,0,5,1,9,0,14,2"},
      {"PT1", EntityType::pattern, "PT1=PATERN/LINEAR,P1,V1,3"},
      {"BS1", EntityType::pathSpline, "BS1=BSPLIN/SPLINE,0,0,0,5,1,0,9,0,0,14,2,0"},
      {"RG1", EntityType::region, "RG1=REGION/C1"},
      {"G1", EntityType::gun, "G1=GUN/CONE,20,STNDOF,200,FLOW,.5"},
  };
  return all;
}

std::vector<KnownName> names() {
  std::vector<KnownName> all = {{"A1", KnownName::Kind::scalar, {}}};
  for (const Sample& s : samples()) {
    all.push_back({s.name, KnownName::Kind::entity, s.type});
  }
  return all;
}

std::string preamble() {
  std::string text = "INTOL/.01\nOUTTOL/.01\nCUTTER/2\nA1=1\n";
  for (const Sample& s : samples()) {
    text += s.definition + "\n";
  }
  return text + "FROM/0,-9,0\nINDEX/1\n";
}

/// The continuation of a noun or of a statement by its row.
define::Continuation continuationOf(Word head, const std::vector<Symbol>& given) {
  const frontend::StatementForm* form = frontend::statementForm(head);
  return form == nullptr ? define::continuation(head, given)
                         : define::continuation(define::compile(form->pattern), given);
}

/// How what is wanted is written, with its symbol; none of it where no sample fits.
std::optional<std::pair<std::string, Symbol>> written(const define::Expectation& wanted) {
  switch (wanted.sort) {
    case Symbol::Sort::scalar: {
      if (wanted.text == "name") {
        return std::pair(std::string("NEW9"), Symbol::scalar());
      }
      const bool digits = wanted.text.find_first_not_of("0123456789") == std::string_view::npos;
      return std::pair(digits ? std::string(wanted.text) : std::string("1"), Symbol::scalar());
    }
    case Symbol::Sort::word:
      return std::pair(std::string(spell(wanted.word)), Symbol::of(wanted.word));
    case Symbol::Sort::text:
      return std::pair(std::string("'A'"), Symbol::text());
    case Symbol::Sort::entity:
      for (const Sample& s : samples()) {
        if ((wanted.types >> static_cast<unsigned>(s.type) & 1U) != 0) {
          return std::pair(s.name, Symbol::of(s.type));
        }
      }
      return std::nullopt;
    case Symbol::Sort::empty:
      return std::nullopt;
  }
  return std::nullopt;
}

/// The shortest way to a whole statement, breadth first; "" if there is none.
std::string finished(Word head, const std::string& begin, const std::vector<Symbol>& given) {
  constexpr std::size_t longest = 24;
  std::vector<std::pair<std::string, std::vector<Symbol>>> now = {{begin, given}};
  for (std::size_t round = 0; round < longest && !now.empty(); ++round) {
    std::vector<std::pair<std::string, std::vector<Symbol>>> next;
    for (const auto& [text, symbols] : now) {
      const define::Continuation more = continuationOf(head, symbols);
      if (more.mayEnd) {
        return text;
      }
      for (const define::Expectation& wanted : more.wanted) {
        const auto one = written(wanted);
        if (one && next.size() < 60) {
          next.emplace_back(text + (symbols.empty() ? "" : ",") + one->first, symbols);
          next.back().second.push_back(one->second);
        }
      }
    }
    now = std::move(next);
  }
  return "";
}

Symbol symbolOf(const std::string& candidate) {
  for (const Sample& s : samples()) {
    if (s.name == candidate) {
      return Symbol::of(s.type);
    }
  }
  const auto word = findWord(candidate);
  return word ? Symbol::of(*word) : Symbol::scalar();
}

/// Faults of the form: numbers and places that make no sense together are none.
bool isFaultOfForm(const Diagnostic& d) {
  static const std::set<std::string_view> forms = {
      "E0301", "E0302", "E0303", "E0304", "E0305", "E0307", "E0424", "E0426", "E0429",
      "E0431", "E0432", "E0433", "E0435", "E0442", "E0443", "E0446", "E0456", "E0457"};
  return forms.contains(d.kind().code) || d.kind().code.starts_with("E02");
}

void tryOffers(Word head,
               const std::string& begin,
               const std::vector<Symbol>& given,
               std::map<std::string, std::string>& statements) {
  for (std::string candidate : frontend::complete(begin, names()).candidates) {
    if (candidate.ends_with('(')) {  // a function is a number like others
      continue;
    }
    std::vector<Symbol> symbols = given;
    symbols.push_back(symbolOf(candidate));
    const std::string whole = finished(head, begin + candidate, symbols);
    EXPECT_NE(whole, "") << begin << " offers " << candidate;
    statements.emplace(begin + candidate, whole);
  }
}

TEST(Offered, EveryWordAndNameLeadsToAStatementOfTheLanguage) {
  std::map<std::string, std::string> statements;  // what was offered: how it was finished
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    const Word head = static_cast<Word>(i);
    const bool noun = row(head).wordClass == WordClass::geometry;
    if (!noun && frontend::statementForm(head) == nullptr) {
      continue;
    }
    const std::string begin = (noun ? "X=" : "") + std::string(spell(head)) + "/";
    tryOffers(head, begin, {}, statements);
    for (const define::Expectation& first : continuationOf(head, {}).wanted) {
      if (const auto one = written(first)) {
        tryOffers(head, begin + one->first + ",", {one->second}, statements);
      }
    }
  }
  EXPECT_GT(statements.size(), 1000U);
  for (const auto& [offered, whole] : statements) {
    if (whole.starts_with("READ/")) {  // what follows would be its data, and its names are files
      continue;
    }
    const SectionOne run(preamble() + whole + "\nFINI\n");
    for (const Diagnostic& d : run.sink.all()) {
      EXPECT_FALSE(isFaultOfForm(d)) << offered << " as " << whole << "\n" << run.messages();
    }
  }
}

TEST(Offered, WhatTakesParametersHasARow) {
  using enum WordClass;
  for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
    const Word word = static_cast<Word>(i);
    const WordClass c = row(word).wordClass;
    if (c == postWithParameters || c == motion || c == arelemValue || c == spray || c == stencil) {
      EXPECT_NE(frontend::statementForm(word), nullptr) << spell(word);
    }
  }
}

}  // namespace
}  // namespace arelem::test
