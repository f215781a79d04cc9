#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arelem::vplus {

struct Token {
  enum class Kind : std::uint8_t { word, number, text, sign, end };
  Kind kind = Kind::end;
  std::string text;  ///< words in upper case, signs as they are, texts without quotes
  double number = 0.0;
  std::size_t column = 1;
};

/// The tokens of one line without its comment; an `end` token comes last. What no token begins with
/// becomes a sign of that character.
[[nodiscard]] std::vector<Token> tokensOf(std::string_view line);

}  // namespace arelem::vplus
