#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/dialect.h"
#include "ir/limits.h"
#include "ir/words/words.h"

namespace arelem::frontend {

/// One logical statement of a text, with the lines on which it stands.
struct OutlinedStatement {
  std::uint32_t begin = 0, end = 0;  ///< bytes of its lines, with the last line's end
  std::string text;         ///< without blanks and comments, in upper case; "" of a comment
  Word head = Word::count;  ///< first word of the vocabulary behind a label; count: none
  bool definition = false;  ///< TYPE/ ... without a name
  /// A scalar expression without a name; a single name is one too.
  bool expression = false;
};

/// Cuts a text into statements without checking them. Linear in the text.
[[nodiscard]] std::vector<OutlinedStatement> outline(std::string_view text,
                                                     Dialect dialect,
                                                     const Limits& limits);

}  // namespace arelem::frontend
