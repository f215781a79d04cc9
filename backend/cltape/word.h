#pragma once
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// The 8-byte words of a CLTAPE. Source: layout of the CL tape of the APT360 port; a word is a
/// double, an integer (low half the value, high half 0), six characters of text, or a
/// right-justified name.
namespace arelem::backend::tape {

using TapeWord = std::uint64_t;

[[nodiscard]] inline TapeWord numberWord(double value) {
  return std::bit_cast<TapeWord>(value);
}
[[nodiscard]] inline double asNumber(TapeWord word) {
  return std::bit_cast<double>(word);
}

[[nodiscard]] inline TapeWord integerWord(int value) {
  return static_cast<std::uint32_t>(value);
}
/// The low half, whatever stands in the high one.
[[nodiscard]] inline int asInteger(TapeWord word) {
  return static_cast<int>(static_cast<std::uint32_t>(word));
}

/// High half 0 and low half not: how a parameter of a post word tells a minor word from a number.
[[nodiscard]] inline bool isCode(TapeWord word) {
  return word != 0 && (word >> 32U) == 0;
}

/// Up to six characters, blank padded to eight.
inline constexpr std::size_t wordCharacters = 6;
[[nodiscard]] TapeWord textWord(std::string_view text);
/// The same with a mark in the padding: the text goes on in the next word. An extension for the
/// long words of later systems; a reader of six-character words sees the pieces.
[[nodiscard]] TapeWord continuedTextWord(std::string_view text);
[[nodiscard]] bool isText(TapeWord word);
[[nodiscard]] bool isContinued(TapeWord word);
/// The first six characters, blanks at the end included.
[[nodiscard]] std::string sixCharacters(TapeWord word);

/// All eight characters: card ids.
[[nodiscard]] TapeWord eightCharacterWord(std::string_view text);
[[nodiscard]] std::string eightCharacters(TapeWord word);

/// A name: right-justified in six characters and two blanks, `"    L1  "`. Names of seven and eight
/// characters fill the word, longer ones lose their end. The unnamed is 0.
[[nodiscard]] TapeWord nameWord(std::string_view name);
/// The name without blanks; "" for 0. nullopt when the word is no text.
[[nodiscard]] std::optional<std::string> asName(TapeWord word);

/// A parameter of a post word. The few numbers that a reader would take for a code or for text
/// (below 1e-153) become 0.
[[nodiscard]] TapeWord parameterWord(double value);

}  // namespace arelem::backend::tape
