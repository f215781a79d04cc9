#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program/statement.h"
#include "ir/text/span.h"

namespace arelem::frontend {

/// One logical statement as the card reader leaves it: cards joined, comments and blanks gone,
/// letters in upper case. Reused from statement to statement.
struct StatementText {
  enum class Kind : std::uint8_t {
    end,      ///< no more cards
    empty,    ///< blank or comment card: only its number counts
    numbers,  ///< GOTO or FROM with plain numbers: `numbers` is filled
    frame,    ///< the frame in a comment of CATIA: `fixedText` is its name, `frame` its rows
    fixed,    ///< PARTNO, PPRINT, INSERT, TITLES, REMARK: `fixedText` is filled
    tokens    ///< anything else: `text` is filled
  };
  Kind kind = Kind::end;
  std::uint32_t isn = 0;
  Span span;
  std::string_view cardId;
  std::string text;                    ///< without blanks, except inside quotes
  std::vector<std::uint32_t> offsets;  ///< source offset of every character of `text`
  std::vector<Span> pieces;            ///< statement field of every card, comments cut off
  Word fixedWord = Word::REMARK;
  std::string fixedText;
  ir::LocateNumbers numbers;
  std::array<double, 12> frame{};

  /// Source span of text[begin, end).
  [[nodiscard]] Span spanOf(std::size_t begin, std::size_t end) const {
    if (begin >= offsets.size()) {
      return {span.buffer, span.end(), 0};
    }
    if (end <= begin) {
      return {span.buffer, offsets[begin], 0};
    }
    return {span.buffer, offsets[begin], offsets[end - 1] + 1 - offsets[begin]};
  }
};

}  // namespace arelem::frontend
