#include "ir/words/post_forms.h"

#include <algorithm>
#include <array>

namespace arelem {

namespace {
constexpr std::array table = {
#define ARELEM_POST(word, pattern, example, least, most, words, acts, meaning) \
  PostForm{Word::word, pattern, least, most, words, acts, meaning},
#define ARELEM_BARE(word, acts, meaning) PostForm{Word::word, "", 0, 0, "", acts, meaning},
#include "ir/words/post_forms.def"
#undef ARELEM_POST
};
}  // namespace

bool PostForm::takes(std::string_view parameter) const {
  if (words == "*") {
    return true;
  }
  for (std::string_view rest = words; !rest.empty();) {
    const std::size_t blank = rest.find(' ');
    if (rest.substr(0, blank) == parameter) {
      return true;
    }
    rest = blank == std::string_view::npos ? std::string_view() : rest.substr(blank + 1);
  }
  return false;
}

std::span<const PostForm> postForms() {
  return table;
}

const PostForm* postForm(Word word) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [word](const PostForm& form) { return form.word == word; });
  return found == table.end() ? nullptr : &*found;
}

}  // namespace arelem
