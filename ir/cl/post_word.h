#pragma once
#include <algorithm>
#include <string_view>
#include <vector>

#include "ir/cl/record.h"

namespace arelem::cl {

/// As it is written: a word of the vocabulary, or one that only its file knows.
[[nodiscard]] inline std::string_view nameOf(const Post& post) {
  return post.foreign.empty() ? spell(post.word) : std::string_view(post.foreign);
}
[[nodiscard]] inline bool is(const Post& post, Word word) {
  return post.foreign.empty() && post.word == word;
}
/// The post-processor word of a record where it is this one, else null.
[[nodiscard]] inline const Post* postOf(const Body& body, Word word) {
  const auto* post = std::get_if<Post>(&body);
  return post != nullptr && is(*post, word) ? post : nullptr;
}
/// A command whose effect the records already have: no back end carries it out again.
[[nodiscard]] inline bool isApplied(const Post& post) {
  if (!post.foreign.empty()) {
    return false;
  }
  switch (post.word) {
    case Word::TRACUT:
    case Word::COPY:
    case Word::INDEX:
    case Word::SMOOTH:
    case Word::VTLAXS:
    case Word::WCORN:
      return true;
    default:
      return false;
  }
}
/// Whether the word stands among its parameters.
[[nodiscard]] inline bool has(const Post& post, Word word) {
  return std::any_of(post.arguments.begin(), post.arguments.end(), [word](const Value& value) {
    const Word* found = std::get_if<Word>(&value);
    return found != nullptr && *found == word;
  });
}
/// The first number among its parameters, wherever it stands; null where there is none.
[[nodiscard]] inline const double* firstNumber(const Post& post) {
  for (const Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      return number;
    }
  }
  return nullptr;
}
/// The numbers among its parameters, in order.
[[nodiscard]] inline std::vector<double> numbersOf(const Post& post) {
  std::vector<double> numbers;
  for (const Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      numbers.push_back(*number);
    }
  }
  return numbers;
}

}  // namespace arelem::cl
