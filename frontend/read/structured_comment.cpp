#include "frontend/read/structured_comment.h"

#include <array>

namespace arelem::frontend {

bool endsInDollar(std::string_view line) {
  const std::size_t last = line.find_last_not_of(" \t");
  return last != std::string_view::npos && line[last] == '$';
}

std::optional<StructuredComment> structuredComment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || !line.substr(begin).starts_with("$$")) {
    return std::nullopt;
  }
  const std::size_t arrow = line.find_first_not_of(" \t", begin + 2);
  if (arrow == std::string_view::npos || !line.substr(arrow).starts_with("->")) {
    return std::nullopt;
  }
  StructuredComment comment;
  comment.continues = endsInDollar(line);
  const std::size_t word = line.find_first_not_of(" \t", arrow + 2);
  constexpr std::array<std::string_view, 2> statements = {"CUTTER", "CSYS"};
  for (const std::string_view statement : statements) {
    if (word == std::string_view::npos || !line.substr(word).starts_with(statement)) {
      continue;
    }
    const std::size_t slash = line.find_first_not_of(" \t", word + statement.size());
    if (slash != std::string_view::npos && line[slash] == '/') {
      comment.statement = word;
    }
  }
  return comment;
}

}  // namespace arelem::frontend
