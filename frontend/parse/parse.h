#pragma once
#include <memory>
#include <optional>
#include <span>

#include "frontend/parse/tree.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"

namespace arelem::frontend {

/// Tokens of one statement to its tree. Plain statements (no nesting, no arithmetic) take a
/// hand-written lane; the rest goes to the parser generated from grammar/AptParser.g4. Both give
/// the same tree. Never throws.
class StatementParser {
 public:
  explicit StatementParser(const Limits& limits);
  ~StatementParser();
  StatementParser(const StatementParser&) = delete;
  StatementParser& operator=(const StatementParser&) = delete;

  /// `tokens` ends with a token of kind `end`. On failure the tree is empty and the diagnostic
  /// tells why.
  [[nodiscard]] std::optional<Diagnostic> parse(std::span<const Token> tokens, StatementTree& tree);
  /// The same without the plain lane.
  [[nodiscard]] std::optional<Diagnostic> parseWithGrammar(std::span<const Token> tokens,
                                                           StatementTree& tree);

 private:
  class Grammar;  // hides ANTLR
  Limits limits_;
  std::unique_ptr<Grammar> grammar_;
};

/// The plain lane alone: false leaves the statement to the grammar.
[[nodiscard]] bool parsePlain(std::span<const Token> tokens, StatementTree& tree);

/// What is wrong with tokens that the grammar refused at `offending`; `expected` is what it would
/// have taken there, in words, or empty.
[[nodiscard]] Diagnostic explainSyntaxError(std::span<const Token> tokens,
                                            std::size_t offending,
                                            const std::string& expected);

/// Bounds that keep the parser's recursion finite: nesting of parentheses and length of operator
/// chains.
[[nodiscard]] std::optional<Diagnostic> checkShapeLimits(std::span<const Token> tokens,
                                                         const Limits& limits);

}  // namespace arelem::frontend
