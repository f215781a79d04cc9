#include "backend/ngc/parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "ir/cl/post_word.h"

namespace arelem::backend::ngc {

namespace {

std::string_view spelling(const cl::Value& value) {
  if (const Word* word = std::get_if<Word>(&value)) {
    return spell(*word);
  }
  const std::string* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string_view() : std::string_view(*text);
}

std::string listed(const std::vector<cl::Value>& values) {
  std::string text;
  for (const cl::Value& value : values) {
    text += text.empty() ? "" : ",";
    if (const double* number = std::get_if<double>(&value)) {
      text += fmt::format("{:.9g}", *number);
    } else {
      const std::string_view word = spelling(value);
      text += word.empty() ? std::string_view("a surface") : word;
    }
  }
  return text;
}

}  // namespace

std::string_view Parameters::take(std::initializer_list<std::string_view> words) {
  for (auto it = left_.begin(); it != left_.end(); ++it) {
    const auto* found = std::find(words.begin(), words.end(), spelling(*it));
    if (found != words.end()) {
      left_.erase(it);
      return *found;
    }
  }
  return {};
}

std::optional<double> Parameters::takeNumber() {
  for (auto it = left_.begin(); it != left_.end(); ++it) {
    if (const double* number = std::get_if<double>(&*it)) {
      const double value = *number;
      left_.erase(it);
      return value;
    }
  }
  return std::nullopt;
}

std::optional<double> Parameters::takeNumberAfter(std::string_view word) {
  for (auto it = left_.begin(); it != left_.end() && it + 1 != left_.end(); ++it) {
    const double* number = std::get_if<double>(&*(it + 1));
    if (spelling(*it) == word && number != nullptr) {
      const double value = *number;
      left_.erase(it, it + 2);
      return value;
    }
  }
  return std::nullopt;
}

std::string Parameters::takePair(std::string_view word) {
  const auto it = std::find_if(left_.begin(), left_.end(),
                               [&](const cl::Value& value) { return spelling(value) == word; });
  if (it == left_.end()) {
    return {};
  }
  const auto end = it + std::min<std::ptrdiff_t>(2, left_.end() - it);
  std::string text = listed(std::vector<cl::Value>(it, end));
  left_.erase(it, end);
  return text;
}

std::string Parameters::rest() const {
  return listed(left_);
}

std::string written(const cl::Post& post) {
  std::string text(cl::nameOf(post));
  return post.arguments.empty() ? text : text + "/" + listed(post.arguments);
}

}  // namespace arelem::backend::ngc
