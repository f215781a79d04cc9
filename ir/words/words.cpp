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

template <class Accept>
std::optional<Word> findCode(int code, Accept accept) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (table[i].code == code && accept(table[i])) {
      return static_cast<Word>(i);
    }
  }
  return std::nullopt;
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
  return findCode(
      code, [](const WordRow& r) { return r.wordClass == WordClass::modifier && !r.extension; });
}

std::optional<Word> findPostWord(int code) {
  return findCode(code, isPost);
}

}  // namespace arelem
