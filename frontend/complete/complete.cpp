#include "frontend/complete/complete.h"

#include <algorithm>
#include <array>
#include <set>

#include "frontend/check/reporter.h"
#include "frontend/complete/scan.h"
#include "frontend/lex/lexer.h"
#include "frontend/read/card_reader.h"
#include "frontend/read/characters.h"
#include "ir/define/continuation.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

namespace {
constexpr std::array forms = {
#define ARELEM_STATEMENT(word, pattern, meaning, example) \
  StatementForm{Word::word, pattern, meaning, example},
#include "frontend/complete/statement_forms.def"
#undef ARELEM_STATEMENT
#define ARELEM_POST(word, pattern, example, least, most, words, acts, meaning) \
  StatementForm{Word::word, pattern, meaning, example},
#include "ir/words/post_forms.def"
#undef ARELEM_POST
};

std::vector<Token> tokensOf(std::string_view text, StatementText& statement, SourceMap& sources) {
  Options options;
  options.dialect = Dialect::native;
  SilentSink sink;
  Reporter reporter(sink, options.limits);
  std::uint32_t isn = 1;
  const BufferId buffer = sources.add("", std::string(text));
  CardReader(sources, buffer, options, reporter, isn).next(statement, false);
  std::vector<Token> tokens;
  if (statement.kind == StatementText::Kind::tokens) {
    const Vocabulary vocabulary(options.dialect);
    static_cast<void>(Lexer(vocabulary, options, reporter).run(statement, tokens));
    tokens.pop_back();
  }
  return tokens;
}

bool beginsStatement(WordClass c) {
  using enum WordClass;
  constexpr std::array others = {modifier, function, geometry, phase, unused};
  return std::find(others.begin(), others.end(), c) == others.end();
}

bool standsAlone(WordClass c) {
  using enum WordClass;
  constexpr std::array alone = {loopBracket,  fini,       postWithoutParameters,
                                toolPosition, fixedField, arelemSwitch};
  return std::find(alone.begin(), alone.end(), c) != alone.end();
}

/// Collects candidates that begin with what is typed.
class Candidates {
 public:
  Candidates(std::string prefix, std::span<const KnownName> names)
      : prefix_(std::move(prefix)), names_(names) {}

  void add(std::string_view text, std::string_view ending = "") {
    if (text.starts_with(prefix_)) {
      found_.insert(std::string(text) + std::string(ending));
    }
  }
  template <class Wanted>
  void words(Wanted wanted) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
      const WordRow& w = row(static_cast<Word>(i));
      if (w.wordClass != WordClass::unused && wanted(w)) {
        const bool noun = w.wordClass == WordClass::geometry;
        const bool call = w.wordClass == WordClass::function || w.wordClass == WordClass::ifWord;
        const bool slash = noun || (beginsStatement(w.wordClass) && !standsAlone(w.wordClass) &&
                                    w.text != "TERMAC");
        add(w.text, call ? "(" : slash ? "/" : "");
      }
    }
  }
  void wordsOf(WordClass c) {
    words([c](const WordRow& w) { return w.wordClass == c; });
  }
  void names(KnownName::Kind kind) {
    for (const KnownName& n : names_) {
      if (n.kind == kind) {
        add(n.name);
      }
    }
  }
  void scalars() {
    names(KnownName::Kind::scalar);
    wordsOf(WordClass::function);
  }
  void entities(std::uint64_t types) {
    for (const KnownName& n : names_) {
      if (n.kind == KnownName::Kind::entity && (types >> static_cast<unsigned>(n.type) & 1U) != 0) {
        add(n.name);
      }
    }
  }
  [[nodiscard]] std::vector<std::string> take() const { return {found_.begin(), found_.end()}; }

 private:
  std::string prefix_;
  std::span<const KnownName> names_;
  std::set<std::string> found_;
};

bool isNumber(std::string_view text) {
  return text.find_first_not_of("0123456789") == text.npos;
}

void addContinuation(const define::Continuation& next, Candidates& candidates) {
  using Sort = define::Symbol::Sort;
  for (const define::Expectation& wanted : next.wanted) {
    switch (wanted.sort) {
      case Sort::word:
        candidates.add(spell(wanted.word));
        break;
      case Sort::entity:
        candidates.entities(wanted.types);
        break;
      case Sort::scalar:
        if (isNumber(wanted.text)) {  // one of a few that mean something
          candidates.add(wanted.text);
        } else {
          candidates.scalars();
        }
        break;
      case Sort::text:
      case Sort::empty:
        break;
    }
  }
}

void addParameters(const Place& place, Candidates& candidates) {
  if (place.definition) {
    addContinuation(define::continuation(place.word, place.given), candidates);
  } else if (const StatementForm* form = statementForm(place.word)) {
    addContinuation(define::continuation(define::compile(form->pattern), place.given), candidates);
  }
}

void addAll(const Place& place, Candidates& candidates) {
  switch (place.kind) {
    case Place::Kind::head:
      candidates.words([](const WordRow& w) {
        return beginsStatement(w.wordClass) || w.wordClass == WordClass::geometry;
      });
      candidates.names(KnownName::Kind::scalar);
      candidates.names(KnownName::Kind::entity);
      break;
    case Place::Kind::motion:
      for (const WordClass c :
           {WordClass::toolPosition, WordClass::arelemSwitch, WordClass::motion}) {
        candidates.wordsOf(c);
      }
      break;
    case Place::Kind::value:
      candidates.wordsOf(WordClass::geometry);
      candidates.add("MACRO", "/");
      candidates.scalars();
      candidates.names(KnownName::Kind::entity);
      break;
    case Place::Kind::parameter:
      addParameters(place, candidates);
      break;
    case Place::Kind::expression:
      candidates.scalars();
      break;
    case Place::Kind::subscript:  // A(3), A(ALL), A(2,THRU,ALL,INCR,2)
      for (const Word word : {Word::ALL, Word::THRU, Word::INCR, Word::DECR}) {
        if (word == Word::ALL || word == Word::THRU || !place.given.empty()) {
          candidates.add(spell(word));
        }
      }
      candidates.scalars();
      break;
    case Place::Kind::functionArgument:
      candidates.scalars();
      candidates.names(KnownName::Kind::entity);
      break;
    case Place::Kind::label:
      candidates.names(KnownName::Kind::label);
      break;
    case Place::Kind::macroName:
      candidates.names(KnownName::Kind::macro);
      break;
    case Place::Kind::nothing:
      break;
  }
}
}  // namespace

std::span<const StatementForm> statementForms() {
  return forms;
}

const StatementForm* statementForm(Word word) {
  const auto found = std::find_if(forms.begin(), forms.end(),
                                  [word](const StatementForm& f) { return f.word == word; });
  return found == forms.end() ? nullptr : &*found;
}

Completion complete(std::string_view text, std::span<const KnownName> names) {
  Completion result;
  result.begin = text.size();
  while (result.begin > 0 && isAlphanumeric(text[result.begin - 1])) {
    --result.begin;
  }
  const std::string_view before = text.substr(0, result.begin);
  if (std::count(before.begin(), before.end(), '\'') % 2 != 0 || before.find("$$") != before.npos) {
    return result;
  }
  std::string prefix(text.substr(result.begin));
  std::transform(prefix.begin(), prefix.end(), prefix.begin(), upper);
  SourceMap sources;
  StatementText statement;
  const std::vector<Token> tokens = tokensOf(before, statement, sources);
  Candidates candidates(std::move(prefix), names);
  addAll(placeBehind(tokens, names), candidates);
  result.candidates = candidates.take();
  return result;
}

}  // namespace arelem::frontend
