#pragma once
#include <optional>

#include "ir/cl/post_word.h"

namespace arelem::path {

/// LEFT or RIGHT of a CUTCOM.
[[nodiscard]] inline std::optional<Word> sideOf(const cl::Record& record) {
  if (const cl::Post* post = cl::postOf(record.body, Word::CUTCOM)) {
    for (const cl::Value& value : post->arguments) {
      const Word* word = std::get_if<Word>(&value);
      if (word != nullptr && (*word == Word::LEFT || *word == Word::RIGHT)) {
        return *word;
      }
    }
  }
  return std::nullopt;
}

}  // namespace arelem::path
