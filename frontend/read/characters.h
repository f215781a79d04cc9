#pragma once
#include <array>
#include <cstdint>

namespace arelem::frontend {

/// What a byte means in a statement field.
enum class CharClass : std::uint8_t { other, letter, digit, punctuation, blank, dollar, quote };

struct CharRow {
  CharClass kind = CharClass::other;
  char upper = 0;
};

namespace detail {
constexpr std::array<CharRow, 256> makeCharTable() {
  std::array<CharRow, 256> table{};
  for (int i = 0; i < 256; ++i) {
    table[static_cast<std::size_t>(i)].upper = static_cast<char>(i);
  }
  for (int i = 0; i < 26; ++i) {
    table[static_cast<std::size_t>('A' + i)].kind = CharClass::letter;
    table[static_cast<std::size_t>('a' + i)] = {CharClass::letter, static_cast<char>('A' + i)};
  }
  for (int i = '0'; i <= '9'; ++i) {
    table[static_cast<std::size_t>(i)].kind = CharClass::digit;
  }
  for (const char c : {'+', '-', '*', '/', ',', '.', '(', ')', '='}) {
    table[static_cast<std::size_t>(c)].kind = CharClass::punctuation;
  }
  for (const char c : {' ', '\t'}) {
    table[static_cast<std::size_t>(c)].kind = CharClass::blank;
  }
  table['$'].kind = CharClass::dollar;
  table['\''].kind = CharClass::quote;
  return table;
}
}  // namespace detail

inline constexpr std::array<CharRow, 256> charTable = detail::makeCharTable();

[[nodiscard]] inline const CharRow& classify(char c) {
  return charTable[static_cast<unsigned char>(c)];
}
[[nodiscard]] inline bool isLetter(char c) {
  return classify(c).kind == CharClass::letter;
}
[[nodiscard]] inline bool isDigit(char c) {
  return classify(c).kind == CharClass::digit;
}
[[nodiscard]] inline bool isAlphanumeric(char c) {
  return isLetter(c) || isDigit(c);
}
[[nodiscard]] inline bool isBlank(char c) {
  return classify(c).kind == CharClass::blank;
}
[[nodiscard]] inline char upper(char c) {
  return classify(c).upper;
}

}  // namespace arelem::frontend
