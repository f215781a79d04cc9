#include "backend/cltape/word.h"

#include <algorithm>
#include <array>

#include "backend/text/clean.h"

namespace arelem::backend::tape {

namespace {
using Bytes = std::array<char, 8>;

TapeWord pack(const Bytes& bytes) {
  TapeWord word = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) {
    word = (word << 8U) | static_cast<unsigned char>(bytes[i]);
  }
  return word;
}

Bytes unpack(TapeWord word) {
  Bytes bytes{};
  for (char& byte : bytes) {
    byte = static_cast<char>(word & 0xFFU);
    word >>= 8U;
  }
  return bytes;
}

Bytes blanks() {
  Bytes bytes{};
  bytes.fill(' ');
  return bytes;
}

/// Not a control character; what is beyond ASCII may be a part of a UTF-8 character.
bool isPrintable(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte != 0x7F;
}

/// Copies the text with controls replaced by blanks.
void place(std::string_view text, std::size_t at, Bytes& bytes) {
  for (std::size_t i = 0; i < text.size() && at + i < bytes.size(); ++i) {
    bytes[at + i] = isPrintable(text[i]) ? text[i] : ' ';
  }
}

constexpr char continuationMark = '+';
}  // namespace

TapeWord textWord(std::string_view text) {
  Bytes bytes = blanks();
  place(text.substr(0, wordCharacters), 0, bytes);
  return pack(bytes);
}

TapeWord continuedTextWord(std::string_view text) {
  Bytes bytes = unpack(textWord(text));
  bytes[7] = continuationMark;
  return pack(bytes);
}

bool isText(TapeWord word) {
  const Bytes bytes = unpack(word);
  const bool padded = (bytes[6] == ' ' && (bytes[7] == ' ' || bytes[7] == continuationMark)) ||
                      (bytes[6] == '\0' && bytes[7] == '\0');
  return padded && std::all_of(bytes.begin(), bytes.begin() + wordCharacters, isPrintable);
}

bool isContinued(TapeWord word) {
  return isText(word) && unpack(word)[7] == continuationMark;
}

std::string sixCharacters(TapeWord word) {
  const Bytes bytes = unpack(word);
  std::string text(bytes.begin(), bytes.begin() + wordCharacters);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !isPrintable(c); }, ' ');
  return text;
}

TapeWord eightCharacterWord(std::string_view text) {
  Bytes bytes = blanks();
  place(text, 0, bytes);
  return pack(bytes);
}

std::string eightCharacters(TapeWord word) {
  const Bytes bytes = unpack(word);
  std::string text(bytes.begin(), bytes.end());
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !isPrintable(c); }, ' ');
  return std::string(trimmedRight(text));
}

TapeWord nameWord(std::string_view name) {
  if (name.empty()) {
    return 0;
  }
  if (name.size() > wordCharacters) {
    return eightCharacterWord(name.substr(0, 8));
  }
  Bytes bytes = blanks();
  place(name, wordCharacters - name.size(), bytes);
  return pack(bytes);
}

std::optional<std::string> asName(TapeWord word) {
  if (word == 0) {
    return std::string();
  }
  const Bytes bytes = unpack(word);
  const bool text =
      std::all_of(bytes.begin(), bytes.end(), [](char c) { return isPrintable(c) || c == '\0'; });
  if (!text) {
    return std::nullopt;
  }
  return std::string(trimmed(eightCharacters(word)));
}

TapeWord parameterWord(double value) {
  const TapeWord word = numberWord(value);
  return isCode(word) || isText(word) ? 0 : word;
}

}  // namespace arelem::backend::tape
