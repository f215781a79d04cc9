#include <algorithm>

#include "frontend/block_forms.h"
#include "frontend/parse/parse.h"
#include "ir/diag/frontend.h"
#include "ir/diag/limits.h"

namespace arelem::frontend {

namespace {
using enum TokenKind;

bool isOperator(TokenKind k) {
  return k == plus || k == minus || k == star || k == slash || k == power;
}
bool isSign(TokenKind k) {
  return k == plus || k == minus || k == notOp;
}

/// The first `)` without `(`, or else the last `(` that stays open.
std::optional<Diagnostic> unbalanced(std::span<const Token> tokens) {
  std::vector<const Token*> open;
  const bool label = tokens.size() > 2 && (tokens[0].kind == number || tokens[0].kind == symbol) &&
                     tokens[1].kind == rightParen;
  for (const Token& t : tokens.subspan(label ? 2 : 0)) {
    if (t.kind == leftParen) {
      open.push_back(&t);
    } else if (t.kind == rightParen) {
      if (open.empty()) {
        return diagnose(t.span, diag::UnmatchedClose);
      }
      open.pop_back();
    }
  }
  if (!open.empty()) {
    return diagnose(open.back()->span, diag::UnmatchedOpen);
  }
  return std::nullopt;
}

/// Behind `IF(...)` stands something else than three labels or THEN.
bool isBrokenBranch(std::span<const Token> tokens, std::size_t offending) {
  int depth = 0;
  for (const Token& t : tokens.first(offending)) {
    depth += t.kind == leftParen ? 1 : t.kind == rightParen ? -1 : 0;
  }
  return tokens.front().kind == ifWord && depth == 0;
}

std::string shown(const Token& t) {
  return t.kind == end ? "the end of the statement" : fmt::format("`{}`", t.text);
}
}  // namespace

Diagnostic explainSyntaxError(std::span<const Token> tokens,
                              std::size_t offending,
                              const std::string& expected) {
  if (auto parens = unbalanced(tokens)) {
    return *std::move(parens);
  }
  const Token& bad = tokens[std::min(offending, tokens.size() - 1)];
  const Token* before = offending > 0 ? &tokens[offending - 1] : nullptr;
  if (before == nullptr && bad.kind != symbol && !isWordKind(bad.kind)) {
    return diagnose(bad.span, diag::BadStatementStart, bad.text);
  }
  if (bad.kind == end && before != nullptr) {
    const bool dangling = before->kind == equals || before->kind == slash ||
                          isOperator(before->kind) || before->kind == comma ||
                          before->kind == leftParen;
    if (dangling) {
      return diagnose(before->span, diag::EndsWithPunctuation, before->text);
    }
  }
  if (before != nullptr && before->kind == function && bad.kind != leftParen) {
    return diagnose(before->span, diag::FunctionNeedsParentheses, before->text);
  }
  if (before != nullptr && isOperator(before->kind) && isOperator(bad.kind)) {
    return diagnose(join(before->span, bad.span), diag::AdjacentOperators, before->text, bad.text);
  }
  if (before != nullptr &&
      (isOperator(before->kind) || before->kind == leftParen || before->kind == equals) &&
      isWordKind(bad.kind)) {
    return diagnose(bad.span, diag::WordInExpression, bad.text);
  }
  const bool operand = bad.kind == number || bad.kind == symbol || bad.kind == leftParen;
  if (before != nullptr && operand &&
      (before->kind == rightParen || before->kind == number || before->kind == symbol)) {
    return diagnose(bad.span, diag::OperatorExpected, shown(bad));
  }
  if (isBrokenBranch(tokens, std::min(offending, tokens.size() - 1))) {
    return diagnose(bad.span, diag::IfFormat);
  }
  Diagnostic d = diagnose(bad.span, diag::Misplaced, shown(bad));
  if (tokens.front().kind == doWord) {
    d.help = fmt::format("the form is {}", doForm());
  }
  return expected.empty() ? d : std::move(d).note("here may stand: " + expected);
}

std::optional<Diagnostic> checkShapeLimits(std::span<const Token> tokens, const Limits& limits) {
  constexpr std::size_t maxOperators = 2000;
  constexpr std::uint64_t deepest = 1000;  // what the parser's stack bears, whatever the flag says
  const std::uint64_t nesting = std::min(limits.nesting, deepest);
  std::uint64_t depth = 0;
  std::uint64_t signs = 0;
  std::size_t operators = 0;
  std::size_t powers = 0;
  constexpr std::size_t maxPowers = 39;
  for (const Token& t : tokens) {
    depth += t.kind == leftParen ? 1 : 0;
    depth -= t.kind == rightParen && depth > 0 ? 1 : 0;
    signs = isSign(t.kind) ? signs + 1 : 0;
    const bool separator = t.kind == comma || t.kind == equals;
    operators = separator ? 0
                          : operators + ((isOperator(t.kind) || t.kind == relation ||
                                          t.kind == andOp || t.kind == orOp)
                                             ? 1
                                             : 0);
    powers = t.kind == power                                            ? powers + 1
             : (t.kind == number || t.kind == symbol || isSign(t.kind)) ? powers
                                                                        : 0;
    if (depth > nesting || signs > nesting) {
      return diagnose(t.span, diag::LimitReached, "nested parentheses or signs", nesting,
                      "nesting");
    }
    if (powers > maxPowers) {
      return diagnose(t.span, diag::TooManyPowers, maxPowers);
    }
    if (operators > maxOperators) {
      return diagnose(t.span, diag::TooManyOperators, maxOperators);
    }
  }
  return std::nullopt;
}

}  // namespace arelem::frontend
