#include "frontend/lex/vocabulary.h"

#include "frontend/lex/token.h"

namespace arelem::frontend {

TokenKind kindOf(Word word) {
  switch (row(word).wordClass) {
    case WordClass::geometry:
      return TokenKind::type;
    case WordClass::function:
      return TokenKind::function;
    case WordClass::ifWord:
      return TokenKind::ifWord;
    case WordClass::call:
      return TokenKind::call;
    case WordClass::macroBracket:
      return word == Word::MACRO ? TokenKind::macro : TokenKind::word;
    default:
      return TokenKind::word;
  }
}

bool Vocabulary::canYield(Word word) const {
  const WordRow& r = row(word);
  return r.extension ||
         (r.wordClass == WordClass::unused && rulesOf(dialect_).unusedWordsYield != Leave::refused);
}

std::optional<Word> Vocabulary::find(std::string_view text) const {
  const auto word = findWord(text);
  if (word) {
    const bool absent = row(*word).extension && rulesOf(dialect_).extensionWords == Leave::refused;
    if (!absent && (!canYield(*word) || !yielded_.contains(text))) {
      return word;
    }
  }
  if (!synonyms_.empty()) {
    const auto found = synonyms_.find(text);
    if (found != synonyms_.end()) {
      return found->second;
    }
  }
  return std::nullopt;
}

void Vocabulary::yieldTo(std::string_view name) {
  const auto word = findWord(name);
  if (word && canYield(*word)) {
    yielded_.emplace(name);
  }
}

}  // namespace arelem::frontend
