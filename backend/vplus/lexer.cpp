#include "backend/vplus/lexer.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace arelem::vplus {

namespace {
bool isLetter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isInName(char c) {
  return isLetter(c) || isDigit(c) || c == '.' || c == '_';
}

/// A name or keyword; `#` before it marks joint values, `$` a string.
Token word(std::string_view line, std::size_t& i) {
  Token token{Token::Kind::word, "", 0.0, i + 1};
  do {
    token.text += static_cast<char>(std::toupper(static_cast<unsigned char>(line[i++])));
  } while (i < line.size() && isInName(line[i]));
  return token;
}

Token number(std::string_view line, std::size_t& i) {
  Token token{Token::Kind::number, "", 0.0, i + 1};
  const char* const begin = line.data() + i;
  const auto [end, error] = std::from_chars(begin, line.data() + line.size(), token.number);
  const std::size_t length = error == std::errc{} ? static_cast<std::size_t>(end - begin) : 1;
  token.kind = error == std::errc{} ? Token::Kind::number : Token::Kind::sign;
  token.text = line.substr(i, length);
  i += length;
  return token;
}

Token text(std::string_view line, std::size_t& i) {
  const std::size_t end = line.find('"', i + 1);
  Token token{end == std::string_view::npos ? Token::Kind::sign : Token::Kind::text, "\"", 0.0,
              i + 1};
  if (end != std::string_view::npos) {
    token.text = line.substr(i + 1, end - i - 1);
    i = end + 1;
  } else {
    i = line.size();
  }
  return token;
}
}  // namespace

std::vector<Token> tokensOf(std::string_view line) {
  std::vector<Token> tokens;
  std::size_t i = 0;
  while (i < line.size() && line[i] != ';') {
    const char c = line[i];
    const bool more = i + 1 < line.size();
    if (c == ' ' || c == '\t') {
      ++i;
    } else if (isLetter(c) ||
               ((c == '#' || c == '$' || c == '.') && more && isLetter(line[i + 1]))) {
      tokens.push_back(word(line, i));
    } else if (isDigit(c) || (c == '.' && more && isDigit(line[i + 1]))) {
      tokens.push_back(number(line, i));
    } else if (c == '"') {
      tokens.push_back(text(line, i));
    } else {
      const std::string_view two = line.substr(i, 2);
      const bool pair = two == "==" || two == "<>" || two == "<=" || two == ">=";
      tokens.push_back({Token::Kind::sign, std::string(line.substr(i, pair ? 2 : 1)), 0.0, i + 1});
      i += pair ? 2 : 1;
    }
  }
  tokens.push_back({Token::Kind::end, "", 0.0, std::min(i, line.size()) + 1});
  return tokens;
}

}  // namespace arelem::vplus
