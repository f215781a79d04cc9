#pragma once
#include <cstdint>
#include <string_view>

#include "ir/text/span.h"
#include "ir/words/words.h"

namespace arelem::frontend {

enum class TokenKind : std::uint8_t {
  end,
  number,
  symbol,
  word,
  type,
  function,
  ifWord,
  macro,
  call,
  string,
  comma,
  slash,
  leftParen,
  rightParen,
  equals,
  plus,
  minus,
  star,
  power,
  relation,
  andOp,
  orOp,
  notOp,
  then,
  elseWord,
  elseIf,
  endIf,
  doWord,
  endDo,
  include
};

/// The comparisons of the block form of IF.
enum class Relation : std::uint8_t { equal, notEqual, less, lessEqual, greater, greaterEqual };

struct Token {
  TokenKind kind = TokenKind::end;
  Word word = Word::END;  ///< of word, type, function, ifWord, macro, call
  Relation relation = Relation::equal;
  std::string_view text;  ///< upper case, without blanks
  double number = 0.0;
  Span span;
};

[[nodiscard]] inline bool isWordKind(TokenKind k) {
  return k == TokenKind::word || k == TokenKind::type || k == TokenKind::function ||
         k == TokenKind::ifWord || k == TokenKind::macro || k == TokenKind::call;
}
[[nodiscard]] inline bool isName(const Token& t) {
  return t.kind == TokenKind::symbol;
}

/// The token kind of a vocabulary word.
[[nodiscard]] TokenKind kindOf(Word word);

}  // namespace arelem::frontend
