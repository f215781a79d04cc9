#pragma once
#include <optional>
#include <string_view>

namespace arelem::frontend {

/// A comment `$$-> WORD / ...` of a CAM system.
struct StructuredComment {
  /// Where the statement begins that the comment amounts to (CUTTER, CSYS); none for other words.
  std::optional<std::size_t> statement;
  bool continues = false;  ///< ends in `$`: the next line belongs to it
};

/// Creo and others write data in comments, over several lines if need be, of which only the first
/// begins with `$$`.
[[nodiscard]] std::optional<StructuredComment> structuredComment(std::string_view line);

/// Whether a line of such a comment is continued.
[[nodiscard]] bool endsInDollar(std::string_view line);

}  // namespace arelem::frontend
