#include "frontend/lex/lexer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "frontend/lex/refusal.h"
#include "frontend/read/characters.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
constexpr std::size_t maxDigits = 16;
constexpr std::size_t maxElements360 = 600;
constexpr std::size_t maxName360 = 6;

struct Dotted {
  std::string_view text;
  TokenKind kind;
  Relation relation;
};
constexpr std::array dottedTable = {
    Dotted{".EQ.", TokenKind::relation, Relation::equal},
    Dotted{".NE.", TokenKind::relation, Relation::notEqual},
    Dotted{".LT.", TokenKind::relation, Relation::less},
    Dotted{".LE.", TokenKind::relation, Relation::lessEqual},
    Dotted{".GT.", TokenKind::relation, Relation::greater},
    Dotted{".GE.", TokenKind::relation, Relation::greaterEqual},
    Dotted{".AND.", TokenKind::andOp, Relation::equal},
    Dotted{".OR.", TokenKind::orOp, Relation::equal},
    Dotted{".NOT.", TokenKind::notOp, Relation::equal},
};

const Dotted* findDotted(std::string_view text) {
  for (const Dotted& d : dottedTable) {
    if (text.starts_with(d.text)) {
      return &d;
    }
  }
  return nullptr;
}

std::size_t significantDigits(std::string_view number) {
  std::size_t count = 0;
  for (const char c : number) {
    if (c == 'E') {
      break;
    }
    const bool leadingZero = c == '0' && count == 0;
    count += (isDigit(c) && !leadingZero) ? 1 : 0;
  }
  return count;
}

TokenKind punctuation(char c) {
  switch (c) {
    case ',':
      return TokenKind::comma;
    case '/':
      return TokenKind::slash;
    case '(':
      return TokenKind::leftParen;
    case ')':
      return TokenKind::rightParen;
    case '=':
      return TokenKind::equals;
    case '+':
      return TokenKind::plus;
    case '-':
      return TokenKind::minus;
    default:
      return TokenKind::star;
  }
}
}  // namespace

char Lexer::peek(std::size_t i) const {
  return i < text_.size() ? text_[i] : '\0';
}

bool Lexer::isSymbolChar(std::size_t i) const {
  if (i >= text_.size()) {
    return false;
  }
  const CharClass c = classify(text_[i]).kind;
  return c == CharClass::letter || c == CharClass::digit || c == CharClass::other;
}

void Lexer::finish(TokenKind kind, std::size_t begin, std::size_t end, Token& token) {
  token.kind = kind;
  token.text = text_.substr(begin, end - begin);
  token.span = statement_->spanOf(begin, end);
  at_ = end;
}

bool Lexer::run(const StatementText& statement, std::vector<Token>& tokens) {
  statement_ = &statement;
  text_ = statement.text;
  at_ = 0;
  tokens.clear();
  const bool strict = !options_.takes(&DialectRules::largeSizes);
  const std::uint64_t most = strict
                                 ? std::min<std::uint64_t>(maxElements360, options_.limits.elements)
                                 : options_.limits.elements;
  bool ok = true;
  while (ok && at_ < text_.size()) {
    if (tokens.size() >= most) {
      const Span at = statement.spanOf(at_, at_ + 1);
      if (strict) {
        reporter_.report(diagnose(at, diag::TooManyElements, most));
      } else {
        reporter_.limit(at, "elements", most, "elements of one statement");
      }
      ok = false;
      break;
    }
    tokens.emplace_back();
    ok = next(tokens.back());
    if (!ok) {
      tokens.pop_back();
    }
  }
  Token last;
  last.span = statement.spanOf(text_.size(), text_.size());
  if (!statement.offsets.empty()) {
    last.span.begin = statement.offsets.back() + 1;
  }
  tokens.push_back(last);
  if (options_.takes(&DialectRules::blocks)) {
    retagBlocks(tokens);
  }
  return ok;
}

bool Lexer::next(Token& token) {
  const char c = text_[at_];
  switch (classify(c).kind) {
    case CharClass::letter:
      return finishSymbol(at_, token);
    case CharClass::digit:
      return lexNumberOrSymbol(token);
    case CharClass::quote:
      return lexString(token);
    case CharClass::punctuation:
      break;
    default:
      return finishSymbol(at_, token);
  }
  if (c == '.') {
    return lexDotted(token);
  }
  if (c == '*' && peek(at_ + 1) == '*') {
    finish(TokenKind::power, at_, at_ + 2, token);
    return true;
  }
  finish(punctuation(c), at_, at_ + 1, token);
  return true;
}

bool Lexer::lexString(Token& token) {
  const std::size_t close = text_.find('\'', at_ + 1);  // the reader keeps only closed strings
  finish(TokenKind::string, at_, close == std::string_view::npos ? text_.size() : close + 1, token);
  token.text.remove_prefix(1);
  token.text.remove_suffix(token.text.empty() ? 0 : 1);
  return true;
}

std::size_t Lexer::dottedLength(std::size_t at) const {
  if (!options_.takes(&DialectRules::blocks) || at >= text_.size()) {
    return 0;
  }
  const Dotted* d = findDotted(text_.substr(at));
  return d == nullptr ? 0 : d->text.size();
}

bool Lexer::lexDotted(Token& token) {
  if (const std::size_t length = dottedLength(at_)) {
    const Dotted* d = findDotted(text_.substr(at_));
    token.relation = d->relation;
    finish(d->kind, at_, at_ + length, token);
    return true;
  }
  if (isDigit(peek(at_ + 1))) {
    return lexFraction(at_, at_ + 1, token);
  }
  reporter_.report(diagnose(statement_->spanOf(at_, at_ + 1), diag::StrayPoint));
  return false;
}

/// Digits lead: a number as long as digits and one point follow; any letter directly after them
/// makes a symbol (also E: 1E5 is a symbol, 1.E5 a number).
bool Lexer::lexNumberOrSymbol(Token& token) {
  const std::size_t begin = at_;
  std::size_t i = begin;
  while (isDigit(peek(i))) {
    ++i;
  }
  if (peek(i) == '.' && dottedLength(i) == 0) {
    return lexFraction(begin, i + 1, token);
  }
  const bool exponent = options_.takes(&DialectRules::exponentWithoutPoint) && peek(i) == 'E' &&
                        (isDigit(peek(i + 1)) ||
                         ((peek(i + 1) == '-' || peek(i + 1) == '+') && isDigit(peek(i + 2))));
  if (exponent) {
    return lexFraction(begin, i, token);
  }
  return isSymbolChar(i) ? finishSymbol(begin, token) : finishNumber(begin, i, token);
}

/// `i` stands behind the decimal point (or on the E of a CL number).
bool Lexer::lexFraction(std::size_t begin, std::size_t i, Token& token) {
  while (isDigit(peek(i))) {
    ++i;
  }
  if (peek(i) == 'E') {
    std::size_t k = i + 1;
    k += (peek(k) == '+' || peek(k) == '-') ? 1 : 0;
    const std::size_t digits = k;
    while (isDigit(peek(k))) {
      ++k;
    }
    if (k == digits) {
      reporter_.report(diagnose(statement_->spanOf(begin, k), diag::MalformedNumber,
                                text_.substr(begin, k - begin)));
      return false;
    }
    i = k;
  }
  if (isSymbolChar(i)) {
    while (isSymbolChar(i)) {
      ++i;
    }
    reporter_.report(diagnose(statement_->spanOf(begin, i), diag::MalformedNumber,
                              text_.substr(begin, i - begin)));
    return false;
  }
  if (peek(i) == '.' && dottedLength(i) == 0) {
    reporter_.report(diagnose(statement_->spanOf(i, i + 1), diag::StrayPoint));
    return false;
  }
  return finishNumber(begin, i, token);
}

bool Lexer::finishNumber(std::size_t begin, std::size_t end, Token& token) {
  const std::string_view text = text_.substr(begin, end - begin);
  finish(TokenKind::number, begin, end, token);
  if (!options_.takes(&DialectRules::largeSizes) && significantDigits(text) > maxDigits) {
    reporter_.report(diagnose(token.span, diag::NumberTooLong, significantDigits(text)));
    return false;
  }
  const auto [next, error] = std::from_chars(text.data(), text.data() + text.size(), token.number);
  const bool underflow =
      error == std::errc::result_out_of_range && text.find("E-") != std::string_view::npos;
  if (underflow) {
    token.number = 0.0;
  } else if (error != std::errc{} || !std::isfinite(token.number)) {
    reporter_.report(diagnose(token.span, diag::NumberOutOfRange, text));
    return false;
  }
  return true;
}

bool Lexer::finishSymbol(std::size_t begin, Token& token) {
  std::size_t i = begin + 1;
  while (isSymbolChar(i)) {
    ++i;
  }
  finish(TokenKind::symbol, begin, i, token);
  if (const auto word = vocabulary_.find(token.text)) {
    token.word = *word == Word::GOUGE ? Word::GOUGCK : *word;
    token.kind = kindOf(token.word);
    return true;
  }
  if (!options_.takes(&DialectRules::largeSizes) && token.text.size() > maxName360) {
    reporter_.report(diagnose(token.span, diag::NameTooLong, token.text, token.text.size()));
    return false;
  }
  return true;
}

/// IF ( ) THEN, ELSE, ENDIF, DO/, ENDDO, INCLUDE/, REFUSE/'text': recognized by their place, so
/// that they stay free as names.
void Lexer::retagBlocks(std::vector<Token>& tokens) const {
  std::size_t first = 0;
  if (tokens.size() > 2 && tokens[1].kind == TokenKind::rightParen) {
    first = 2;
  }
  Token& head = tokens[first];
  if (head.kind == TokenKind::ifWord || head.kind == TokenKind::symbol) {
    Token& last = tokens[tokens.size() >= 2 ? tokens.size() - 2 : 0];
    const TokenKind after = first + 1 < tokens.size() ? tokens[first + 1].kind : TokenKind::end;
    const bool elseIf = head.text == "ELSEIF" && after == TokenKind::leftParen;
    if ((head.kind == TokenKind::ifWord || elseIf) && last.kind == TokenKind::symbol &&
        last.text == "THEN") {
      last.kind = TokenKind::then;
      head.kind = elseIf ? TokenKind::elseIf : head.kind;
    } else if (after == TokenKind::end) {
      head.kind = head.text == "ELSE"    ? TokenKind::elseWord
                  : head.text == "ENDIF" ? TokenKind::endIf
                  : head.text == "ENDDO" ? TokenKind::endDo
                                         : head.kind;
    } else if (after == TokenKind::slash && head.text == refusal &&
               tokens[first + 2].kind == TokenKind::string) {
      head.word = Word::ENGRAV;  // the form of its parameters; the checker looks at the text
      head.kind = kindOf(head.word);
    } else if (after == TokenKind::slash) {
      head.kind = head.text == "DO"        ? TokenKind::doWord
                  : head.text == "INCLUDE" ? TokenKind::include
                                           : head.kind;
    }
  }
}

}  // namespace arelem::frontend
