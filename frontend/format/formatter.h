#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "frontend/compile.h"

namespace arelem::frontend {

/// What becomes of the identification in columns 73-80.
enum class CardIds : std::uint8_t { keep, drop };

struct FormatOptions {
  Dialect dialect = Dialect::automatic;
  Limits limits;
  CardIds ids = CardIds::keep;
};

struct Formatted {
  std::string text;
  std::size_t statements = 0;
  /// Statements that stand as they stood, as they cannot be read as tokens or do not fit.
  std::size_t untouched = 0;
  bool clText = false;  ///< CL text of a CAM system: nothing is changed in such a file
};

/// Lays a part program out anew: upper case, no blanks within words and numbers, loops, macros and
/// blocks indented by two, statements broken at commas where a card is longer than column 72.
/// Comments, breaks of statements over cards, the text of PARTNO and its like, data of READ/1 and
/// what follows FINI stay. Every logical statement keeps its tokens, its number and (with
/// CardIds::keep) its identification: the result is read again and compared, and a statement that
/// would change stays as it stood. Formatting the result once more gives the same text.
/// Time and memory: linear in the text.
[[nodiscard]] Formatted format(std::string_view text, const FormatOptions& options);

}  // namespace arelem::frontend
