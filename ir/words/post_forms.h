#pragma once
#include <span>
#include <string_view>

#include "ir/words/words.h"

namespace arelem {

/// What a word for the machine takes behind its slash.
struct PostForm {
  Word word;
  std::string_view pattern;  ///< the usual form; "" of a word that stands alone
  int least = 0;          ///< numbers
  int most = 0;
  std::string_view words;  ///< that may stand in the list, with blanks between; "*" any
  bool acts = false;       ///< outputs, times or the reading of places act on it
  std::string_view meaning;

  [[nodiscard]] bool takes(std::string_view parameter) const;
};

[[nodiscard]] std::span<const PostForm> postForms();
/// Null for words that the table does not have: those without parameters, and MACHIN's like.
[[nodiscard]] const PostForm* postForm(Word word);

}  // namespace arelem
