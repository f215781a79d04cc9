#include "ir/words/words.h"

#include <array>
#include <unordered_map>

namespace arelem {

namespace {
constexpr auto table = std::to_array<WordRow>({
#define ARELEM_WORD(identifier, text, wordClass, type, code) \
  WordRow{text, WordClass::wordClass, type, code, false},
#define ARELEM_EXTENSION(identifier, text, wordClass, type, code) \
  WordRow{text, WordClass::wordClass, type, code, true},
#include "ir/words/words.def"
#undef ARELEM_WORD
#undef ARELEM_EXTENSION
});

bool isPost(const WordRow& word) {
  return word.type == 2000;
}

/// The first word of each code that is accepted.
template <class Accept>
std::unordered_map<int, Word> codesOf(Accept accept) {
  std::unordered_map<int, Word> map;
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (accept(table[i])) {
      map.emplace(table[i].code, static_cast<Word>(i));
    }
  }
  return map;
}

std::optional<Word> found(const std::unordered_map<int, Word>& map, int code) {
  const auto at = map.find(code);
  return at == map.end() ? std::nullopt : std::optional(at->second);
}
}  // namespace

const WordRow& row(Word word) {
  return table[static_cast<std::size_t>(word)];
}

std::optional<Word> findWord(std::string_view text) {
  static const auto index = [] {
    std::unordered_map<std::string_view, Word> map;
    for (std::size_t i = 0; i < table.size(); ++i) {
      map.emplace(table[i].text, static_cast<Word>(i));
    }
    return map;
  }();
  const auto found = index.find(text);
  return found == index.end() ? std::nullopt : std::optional<Word>(found->second);
}

std::optional<Word> findModifier(int code) {
  static const auto index =
      codesOf([](const WordRow& r) { return r.wordClass == WordClass::modifier && !r.extension; });
  return found(index, code);
}

std::optional<Word> findPostWord(int code) {
  static const auto index = codesOf(isPost);
  return found(index, code);
}

}  // namespace arelem
