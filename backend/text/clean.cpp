#include "backend/text/clean.h"

#include <cstdint>

#include <fmt/format.h>

namespace arelem::backend {

namespace {
constexpr std::string_view replacement = "\xEF\xBF\xBD";

unsigned char byteAt(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// Length of the UTF-8 sequence that a leading byte announces, 0 for one that cannot lead.
std::size_t announcedLength(unsigned char lead) {
  if (lead < 0x80) {
    return 1;
  }
  if (lead >= 0xC2 && lead < 0xE0) {
    return 2;
  }
  if (lead >= 0xE0 && lead < 0xF0) {
    return 3;
  }
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

/// The code point of one valid UTF-8 character.
std::uint32_t codePoint(std::string_view character) {
  const unsigned char lead = byteAt(character, 0);
  std::uint32_t code = character.size() == 1 ? lead : lead & (0xFFU >> (character.size() + 1));
  for (std::size_t k = 1; k < character.size(); ++k) {
    code = (code << 6U) | (byteAt(character, k) & 0x3FU);
  }
  return code;
}

/// Length of the valid UTF-8 sequence at `i`, or 0. Refuses surrogates and overlong forms.
std::size_t sequenceLength(std::string_view text, std::size_t i) {
  const unsigned char lead = byteAt(text, i);
  const std::size_t length = announcedLength(lead);
  if (length == 0 || i + length > text.size()) {
    return 0;
  }
  for (std::size_t k = 1; k < length; ++k) {
    if ((byteAt(text, i + k) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  const std::uint32_t code = codePoint(text.substr(i, length));
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return overlong || surrogate || code > 0x10FFFF ? 0 : length;
}

/// A character that moves a terminal's cursor or turns the reading direction.
bool isHidden(std::string_view character) {
  if (character.size() == 1) {
    return static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7F;
  }
  const bool c1 = character.size() == 2 && character[0] == '\xC2' && byteAt(character, 1) < 0xA0;
  const bool direction = character.size() == 3 && byteAt(character, 0) == 0xE2 &&
                         ((byteAt(character, 1) == 0x80 && byteAt(character, 2) >= 0xAA &&
                           byteAt(character, 2) <= 0xAE) ||
                          (byteAt(character, 1) == 0x81 && byteAt(character, 2) >= 0xA6 &&
                           byteAt(character, 2) <= 0xA9));
  return c1 || direction;
}

/// Calls `each` with every character of the text, and with an empty view for a byte that is not
/// UTF-8.
template <class Each>
void forEachCharacter(std::string_view text, Each each) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequenceLength(text, i);
    each(text.substr(i, length));
    i += length == 0 ? 1 : length;
  }
}
}  // namespace

std::string printableAscii(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  forEachCharacter(text, [&out](std::string_view character) {
    if (character.size() != 1) {
      out += '?';
    } else {
      out += isHidden(character) ? ' ' : character[0];
    }
  });
  return out;
}

std::string restOfLine(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  forEachCharacter(text, [&out](std::string_view character) {
    if (character.empty()) {
      out += '?';
    } else if (isHidden(character)) {
      out += ' ';
    } else {
      out += character;
    }
  });
  out.resize(trimmedRight(out).size());
  for (std::size_t i = out.size(); i > 0 && out[i - 1] == '$'; --i) {
    out[i - 1] = '#';
  }
  return out;
}

std::string statementText(std::string_view text) {
  std::string out = printableAscii(text);
  for (char& c : out) {
    c = c == '$' ? '#' : c;
  }
  out.resize(trimmedRight(out).size());
  return out;
}

void appendJsonString(std::string& out, std::string_view text) {
  out += '"';
  forEachCharacter(text, [&out](std::string_view character) {
    if (character.empty()) {
      out += replacement;
    } else if (character == "\"" || character == "\\") {
      out += '\\';
      out += character;
    } else if (isHidden(character)) {
      out += fmt::format("\\u{:04x}", codePoint(character));
    } else {
      out += character;
    }
  });
  out += '"';
}

std::string xmlText(std::string_view text) {
  std::string out;
  forEachCharacter(text, [&out](std::string_view character) {
    if (character == "&") {
      out += "&amp;";
    } else if (character == "<") {
      out += "&lt;";
    } else if (character == ">") {
      out += "&gt;";
    } else if (character == "\"") {
      out += "&quot;";
    } else if (character == "'") {
      out += "&#39;";
    } else {
      out += character.empty() || isHidden(character) ? replacement : character;
    }
  });
  return out;
}

std::string_view trimmedRight(std::string_view text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) {
    text.remove_suffix(1);
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  text = trimmedRight(text);
  while (!text.empty() && (text.front() == ' ' || text.front() == '\0')) {
    text.remove_prefix(1);
  }
  return text;
}

}  // namespace arelem::backend
