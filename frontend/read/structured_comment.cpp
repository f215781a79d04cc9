#include "frontend/read/structured_comment.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "frontend/read/characters.h"

namespace arelem::frontend {

namespace {
constexpr std::string_view blanks = " \t\r";

/// Behind `$$`, in the line; npos where there is none.
std::size_t behindDollars(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(blanks);
  const bool comment = begin != std::string_view::npos && line.substr(begin).starts_with("$$");
  return comment ? begin + 2 : std::string_view::npos;
}

/// Whether the text begins with a key in capital letters, however it is spaced from what follows.
bool isKey(std::string_view text, std::string_view key, char mark) {
  if (!text.starts_with(key)) {
    return false;
  }
  const std::size_t behind = text.find_first_not_of(blanks, key.size());
  return behind != std::string_view::npos && text[behind] == mark;
}

/// `-> KEY / value`, from the arrow on.
StructuredComment arrowComment(std::string_view line, std::size_t arrow) {
  StructuredComment comment;
  comment.continues = endsInDollar(line);
  const std::size_t word = line.find_first_not_of(blanks, arrow + 2);
  if (word == std::string_view::npos) {
    return comment;
  }
  const std::string_view text = line.substr(word);
  constexpr std::array<std::string_view, 4> statements = {"CUTTER", "CSYS", "VTLAXS", "WCORN"};
  if (std::any_of(statements.begin(), statements.end(),
                  [&](std::string_view key) { return isKey(text, key, '/'); })) {
    comment.statement = word;
  } else if (isKey(text, "FEATNO", '/')) {
    comment.text = word;
  }
  return comment;
}
}  // namespace

bool endsInDollar(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t");
  return last != std::string_view::npos && line[last] == '$';
}

std::optional<StructuredComment> structuredComment(std::string_view line) {
  const std::size_t dollars = behindDollars(line);
  if (dollars == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t begin = line.find_first_not_of(blanks, dollars);
  if (begin == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view text = line.substr(begin);
  if (text.starts_with("->")) {
    return arrowComment(line, begin);
  }
  StructuredComment comment;
  if (text.starts_with("*CATIA0")) {
    comment.frame = true;
    return comment;
  }
  if (isKey(text, "OPERATION NAME", ':')) {
    comment.text = begin;
    return comment;
  }
  return std::nullopt;
}

std::optional<std::string_view> commentText(std::string_view line) {
  const std::size_t begin = behindDollars(line);
  if (begin == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view text = line.substr(begin);
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(blanks) + 1));
  return text;
}

std::optional<std::array<double, 4>> matrixRow(std::string_view line) {
  const auto text = commentText(line);
  if (!text) {
    return std::nullopt;
  }
  std::array<double, 4> row{};
  const char* p = text->data();
  const char* const end = p + text->size();
  for (double& number : row) {
    while (p != end && isBlank(*p)) {
      ++p;
    }
    const auto [next, error] = std::from_chars(p, end, number);
    if (error != std::errc{} || (next != end && !isBlank(*next))) {
      return std::nullopt;
    }
    p = next;
  }
  return p == end ? std::optional(row) : std::nullopt;
}

}  // namespace arelem::frontend
