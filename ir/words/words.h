#pragma once
#include <cstdint>
#include <optional>
#include <string_view>

namespace arelem {

/// What a vocabulary word may do in a statement; the processing classes of the old Section 1.
enum class WordClass : std::uint8_t {
#define ARELEM_WORD_CLASS(name) name,
#include "ir/words/classes.def"
#undef ARELEM_WORD_CLASS
};

/// A vocabulary word. Enumerators are spelt as the word, with W_ before a leading digit.
enum class Word : std::uint16_t {
#define ARELEM_WORD(identifier, text, wordClass, type, code) identifier,
#define ARELEM_EXTENSION(identifier, text, wordClass, type, code) identifier,
#include "ir/words/words.def"
#undef ARELEM_WORD
#undef ARELEM_EXTENSION
  count
};

struct WordRow {
  std::string_view text;
  WordClass wordClass;
  std::int16_t type;  ///< CLTAPE record class, or 0
  std::int16_t code;  ///< CLTAPE subclass, or the integer code of a modifier
  bool extension;     ///< a word of later systems: yields to a symbol of the same name
};

[[nodiscard]] const WordRow& row(Word word);
[[nodiscard]] inline std::string_view spell(Word word) {
  return row(word).text;
}
/// Looks up upper-case text.
[[nodiscard]] std::optional<Word> findWord(std::string_view text);
/// The word of class `modifier` with this code; the first one listed where two share a code.
[[nodiscard]] std::optional<Word> findModifier(int code);
/// The post-processor word (record class 2000) with this subclass.
[[nodiscard]] std::optional<Word> findPostWord(int code);

}  // namespace arelem
