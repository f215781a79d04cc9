#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/cl/record.h"

namespace arelem::backend::ngc {

/// The parameters of a statement, taken one by one: what no form takes is left, and can be told.
class Parameters {
 public:
  explicit Parameters(const cl::Post& post) : left_(post.arguments) {}

  /// Takes the first of these words, of the vocabulary or not; "" when none is there.
  std::string_view take(std::initializer_list<std::string_view> words);
  /// Takes the first number.
  std::optional<double> takeNumber();
  /// Takes a word with the number behind it; neither when one of them is missing.
  std::optional<double> takeNumberAfter(std::string_view word);
  /// Takes a word and the value behind it, if there is one, and tells them as they are written; ""
  /// when the word is missing.
  std::string takePair(std::string_view word);
  /// What is left, as it is written; "" when nothing is.
  [[nodiscard]] std::string rest() const;

 private:
  std::vector<cl::Value> left_;
};

/// A statement as it is written: `ROTABL/30`.
[[nodiscard]] std::string written(const cl::Post& post);

}  // namespace arelem::backend::ngc
