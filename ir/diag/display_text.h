#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arelem {

/// One glyph of a source line as a terminal shows it: tabs are spaces, characters that would move
/// the cursor, hide or reorder text are spelt out.
struct Cell {
  std::uint32_t begin = 0;  ///< first byte in the line
  std::uint32_t end = 0;    ///< one past its last byte
  std::string text;         ///< what is printed
  std::uint32_t width = 1;  ///< columns that it takes
};

/// Columns between tab stops, as on the old card images.
inline constexpr std::uint32_t tabStop = 8;

/// The cells of one line. Never fails: a byte that is not UTF-8 is shown as `\xE4`.
[[nodiscard]] std::vector<Cell> displayCells(std::string_view line);

/// Any text made safe for one line of output: control characters and bad bytes are spelt out.
[[nodiscard]] std::string displayText(std::string_view text);

/// One code point of `text` at `at`: its value and length in bytes; length 0 where it is not UTF-8.
struct CodePoint {
  char32_t value = 0;
  std::uint32_t length = 0;
};
[[nodiscard]] CodePoint decodeUtf8(std::string_view text, std::size_t at);

}  // namespace arelem
