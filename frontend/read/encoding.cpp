#include "frontend/read/encoding.h"

#include <array>
#include <cstring>
#include <utility>

#include "ir/diag/diagnostic.h"
#include "ir/diag/frontend.h"

namespace arelem::frontend {

namespace {
bool isControl(unsigned char c) {
  return (c < 0x20U && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != 0x1AU) ||
         c == 0x7FU;
}

std::uint32_t codePoint(std::string_view text, std::size_t at, std::size_t length) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[at + i]));
  };
  switch (length) {
    case 1:
      return byte(0);
    case 2:
      return ((byte(0) & 0x1FU) << 6U) | (byte(1) & 0x3FU);
    case 3:
      return ((byte(0) & 0x0FU) << 12U) | ((byte(1) & 0x3FU) << 6U) | (byte(2) & 0x3FU);
    default:
      return ((byte(0) & 0x07U) << 18U) | ((byte(1) & 0x3FU) << 12U) | ((byte(2) & 0x3FU) << 6U) |
             (byte(3) & 0x3FU);
  }
}

/// Zero-width characters and those that reverse the order in which a line is shown.
bool isInvisible(std::uint32_t c) {
  return (c >= 0x200BU && c <= 0x200FU) || (c >= 0x202AU && c <= 0x202EU) ||
         (c >= 0x2060U && c <= 0x2069U) || c == 0xFEFFU;
}

/// Whether eight bytes are printable ASCII.
bool isPrintable8(const char* p) {
  constexpr std::uint64_t ones = 0x0101010101010101U;
  constexpr std::uint64_t high = ones * 0x80U;
  std::uint64_t w = 0;
  std::memcpy(&w, p, sizeof w);
  const std::uint64_t below32 = (w - ones * 0x20U) & ~w & high;
  const std::uint64_t is127 = (w ^ (ones * 0x7FU)) - ones;
  return ((w | below32 | (is127 & ~(w ^ (ones * 0x7FU)))) & high) == 0;
}

enum class Seen : std::uint8_t { control, notUtf8, invisible };
}  // namespace

std::size_t utf8Length(std::string_view text, std::size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  std::size_t length = 1;
  if (lead >= 0x80U) {
    length = (lead >= 0xC2U && lead < 0xE0U)   ? 2
             : (lead >= 0xE0U && lead < 0xF0U) ? 3
             : (lead >= 0xF0U && lead < 0xF5U) ? 4
                                               : 0;
  }
  if (length == 0 || at + length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  static constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const std::uint32_t c = codePoint(text, at, length);
  const bool surrogate = c >= 0xD800U && c <= 0xDFFFU;
  return c < least[length] || surrogate || c > 0x10FFFFU ? 0 : length;
}

void checkEncoding(std::string_view text, BufferId buffer, Reporter& reporter) {
  std::array<bool, 3> done{};
  const auto first = [&](Seen what) {
    return !std::exchange(done[static_cast<std::size_t>(what)], true);
  };
  for (std::size_t i = 0; i < text.size();) {
    if (i + 8 <= text.size() && isPrintable8(text.data() + i)) {
      i += 8;
      continue;
    }
    const auto c = static_cast<unsigned char>(text[i]);
    const Span at{buffer, static_cast<std::uint32_t>(i), 1};
    if (c < 0x80U) {
      if (isControl(c) && first(Seen::control)) {
        reporter.report(diagnose(at, diag::ControlByte, fmt::format("0x{:02X}", c), i));
      }
      ++i;
      continue;
    }
    const std::size_t length = utf8Length(text, i);
    if (length == 0) {
      if (first(Seen::notUtf8)) {
        reporter.report(diagnose(at, diag::NotUtf8, fmt::format("0x{:02X}", c), i));
      }
      ++i;
      continue;
    }
    const std::uint32_t point = codePoint(text, i, length);
    if (isInvisible(point) && i != 0 && first(Seen::invisible)) {
      reporter.report(diagnose(at, diag::InvisibleCharacter, fmt::format("U+{:04X}", point)));
    }
    i += length;
  }
}

std::string cleanText(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8Length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (length == 0) {
      clean += static_cast<char>(0xC0U | (c >> 6U));
      clean += static_cast<char>(0x80U | (c & 0x3FU));
      ++i;
    } else if (length == 1 && ((c < 0x20U && c != '\t') || c == 0x7FU)) {
      clean += ' ';
      ++i;
    } else {
      clean.append(text, i, length);
      i += length;
    }
  }
  return clean;
}

}  // namespace arelem::frontend
