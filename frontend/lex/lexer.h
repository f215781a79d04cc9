#pragma once
#include <vector>

#include "frontend/check/reporter.h"
#include "frontend/lex/token.h"
#include "frontend/lex/vocabulary.h"
#include "frontend/read/statement_text.h"

namespace arelem::frontend {

/// Cuts a logical statement into tokens (language reference 1.3). The tokens' texts point into the
/// statement; the vector always ends with a token of kind `end`.
class Lexer {
 public:
  Lexer(const Vocabulary& vocabulary, const Options& options, Reporter& reporter)
      : vocabulary_(vocabulary), options_(options), reporter_(reporter) {}

  /// Returns false when a token is malformed or a limit is reached; it was reported, and `tokens`
  /// holds what was read before.
  bool run(const StatementText& statement, std::vector<Token>& tokens);

 private:
  bool next(Token& token);
  bool lexNumberOrSymbol(Token& token);
  bool lexFraction(std::size_t begin, std::size_t i, Token& token);
  bool finishNumber(std::size_t begin, std::size_t end, Token& token);
  bool finishSymbol(std::size_t begin, Token& token);
  bool lexDotted(Token& token);
  bool lexString(Token& token);
  void finish(TokenKind kind, std::size_t begin, std::size_t end, Token& token);
  [[nodiscard]] char peek(std::size_t i) const;
  [[nodiscard]] bool isSymbolChar(std::size_t i) const;
  /// Length of `.LT.`, `.AND.` and so on at `at`, or 0.
  [[nodiscard]] std::size_t dottedLength(std::size_t at) const;
  void retagBlocks(std::vector<Token>& tokens) const;

  const Vocabulary& vocabulary_;
  const Options& options_;
  Reporter& reporter_;
  const StatementText* statement_ = nullptr;
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace arelem::frontend
