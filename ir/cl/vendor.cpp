#include "ir/cl/vendor.h"

namespace arelem::cl {

namespace {
bool isTool(const Value& value) {
  const Word* word = std::get_if<Word>(&value);
  return word != nullptr && *word == Word::TOOL;
}
}  // namespace

std::optional<Post> inApt(const Post& post) {
  const bool loads = post.foreign == "LOAD";
  if ((!loads && post.foreign != "SELECT") || post.arguments.size() < 2 ||
      !isTool(post.arguments[0])) {
    return std::nullopt;
  }
  return Post{
      loads ? Word::LOADTL : Word::SELCTL, "", {post.arguments.begin() + 1, post.arguments.end()}};
}

std::optional<std::vector<double>> cutterOf(const Post& post) {
  if (post.foreign != "TLDATA") {
    return std::nullopt;
  }
  std::vector<double> cutter;
  for (const Value& value : post.arguments) {
    const double* number = std::get_if<double>(&value);
    if (number != nullptr && cutter.size() < 2) {
      cutter.push_back(*number);
    }
  }
  return cutter.empty() ? std::nullopt : std::optional(cutter);
}

}  // namespace arelem::cl
