#include "ir/diag/display_text.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace arelem {

namespace {
struct Range {
  char32_t first, last;
};
// Two columns wide: East Asian scripts and pictographs (Unicode 15, UAX 11, blocks rather than
// single characters).
constexpr std::array wide = {
    Range{0x1100, 0x115F},   Range{0x2E80, 0x303E},   Range{0x3041, 0xA4CF},  Range{0xAC00, 0xD7A3},
    Range{0xF900, 0xFAFF},   Range{0xFE30, 0xFE6F},   Range{0xFF00, 0xFF60},  Range{0xFFE0, 0xFFE6},
    Range{0x1F300, 0x1F64F}, Range{0x1F900, 0x1F9FF}, Range{0x20000, 0x3FFFD}};
// Take no column of their own.
constexpr std::array combining = {Range{0x0300, 0x036F}, Range{0x1AB0, 0x1AFF},
                                  Range{0x1DC0, 0x1DFF}, Range{0x20D0, 0x20FF},
                                  Range{0xFE00, 0xFE0F}, Range{0xFE20, 0xFE2F}};
// Invisible, or change the order of what follows: shown by number.
constexpr std::array hidden = {Range{0x0080, 0x009F}, Range{0x00AD, 0x00AD},  Range{0x061C, 0x061C},
                               Range{0x200B, 0x200F}, Range{0x2028, 0x202E},  Range{0x2060, 0x206F},
                               Range{0xFEFF, 0xFEFF}, Range{0xE0000, 0xE007F}};

template <std::size_t n>
bool in(const std::array<Range, n>& ranges, char32_t c) {
  return std::any_of(ranges.begin(), ranges.end(),
                     [c](const Range& r) { return r.first <= c && c <= r.last; });
}

Cell spelt(std::string text) {
  Cell cell;
  cell.width = static_cast<std::uint32_t>(text.size());
  cell.text = std::move(text);
  return cell;
}

Cell cellAt(std::string_view line, std::size_t at, std::uint32_t column) {
  const CodePoint c = decodeUtf8(line, at);
  Cell cell;
  if (c.length == 0) {
    cell = spelt(fmt::format("\\x{:02X}", static_cast<unsigned char>(line[at])));
  } else if (c.value == '\t') {
    cell = spelt(std::string(tabStop - column % tabStop, ' '));
  } else if (c.value < 0x20 || c.value == 0x7F) {
    cell = spelt(fmt::format("\\x{:02X}", static_cast<unsigned>(c.value)));
  } else if (in(hidden, c.value)) {
    cell = spelt(fmt::format("<U+{:04X}>", static_cast<unsigned>(c.value)));
  } else {
    cell.text = line.substr(at, c.length);
    cell.width = in(combining, c.value) ? 0 : in(wide, c.value) ? 2 : 1;
  }
  cell.begin = static_cast<std::uint32_t>(at);
  cell.end = cell.begin + std::max<std::uint32_t>(c.length, 1);
  return cell;
}
}  // namespace

CodePoint decodeUtf8(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) {
    return {first, 1};
  }
  const std::uint32_t length = first >= 0xF0 && first < 0xF5   ? 4
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xC2 && first < 0xE0 ? 2
                                                               : 0;
  if (length == 0 || at + length > text.size()) {
    return {};
  }
  char32_t value = first & (0x7FU >> length);
  for (std::uint32_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0U) != 0x80U) {
      return {};
    }
    value = (value << 6U) | (byte(at + i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < smallest.at(length) || value > 0x10FFFF || surrogate) {
    return {};
  }
  return {value, length};
}

std::vector<Cell> displayCells(std::string_view line) {
  std::vector<Cell> cells;
  std::uint32_t column = 0;
  for (std::size_t at = 0; at < line.size(); at = cells.back().end) {
    cells.push_back(cellAt(line, at, column));
    column += cells.back().width;
  }
  return cells;
}

std::string displayText(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const Cell cell = cellAt(text, at, 0);
    out += text[at] == '\t' ? " " : cell.text;
    at = cell.end;
  }
  return out;
}

}  // namespace arelem
