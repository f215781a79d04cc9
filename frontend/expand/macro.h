#pragma once
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "frontend/lex/token.h"
#include "frontend/read/statement_text.h"
#include "ir/program/id.h"

namespace arelem::frontend {

/// A statement kept for later: its tokens point into `text`, which never moves.
struct StoredStatement {
  StatementText::Kind kind = StatementText::Kind::tokens;
  Span span;
  std::uint32_t isn = 0;
  std::string cardId;
  std::unique_ptr<const std::string> text;
  std::vector<Token> tokens;
  Word fixedWord = Word::REMARK;
  std::string fixedText;
};

/// Copies a statement and its tokens.
[[nodiscard]] StoredStatement store(const StatementText& statement,
                                    const std::vector<Token>& tokens);

struct MacroVariable {
  std::string name;
  std::vector<Token> value;  ///< default, empty: none
  bool refused = false;      ///< its default was an error, which has been reported
  std::unique_ptr<const std::string> text;
};

struct Macro {
  std::string name;
  Span definition;
  std::vector<MacroVariable> variables;
  std::vector<StoredStatement> body;
  bool called = false;
};

using MacroTable = std::map<std::string, Macro, std::less<>>;

/// The statement's tokens with every macro variable replaced by its value.
/// The replaced tokens keep the place of the variable.
void substitute(const std::vector<Token>& tokens,
                const std::map<std::string_view, Token>& values,
                std::vector<Token>& result);

}  // namespace arelem::frontend
