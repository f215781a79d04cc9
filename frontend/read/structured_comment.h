#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace arelem::frontend {

/// A comment with data of a CAM system.
struct StructuredComment {
  std::optional<std::size_t> statement;  ///< where the statement in it begins, if it has one
  std::optional<std::size_t> text;       ///< where the text begins that PPRINT keeps
  bool continues = false;                ///< the next line belongs to it
  bool frame = false;                    ///< a name and the rows of a matrix follow
};

/// `$$-> KEY / value` of Creo and of programs that write like it: CUTTER and CSYS are statements,
/// FEATNO is a text; a `$` at the end goes on in the next line although that line does not begin
/// with
/// `$$`. `$$*CATIA0` of CATIA begins a frame, `$$ OPERATION NAME : x` is a text. None for other
/// lines.
[[nodiscard]] std::optional<StructuredComment> structuredComment(std::string_view line);

/// The text behind the `$$` of a comment line, without blanks round it; none for other lines.
[[nodiscard]] std::optional<std::string_view> commentText(std::string_view line);

/// A row of the matrix behind `$$*CATIA0`: four numbers.
[[nodiscard]] std::optional<std::array<double, 4>> matrixRow(std::string_view line);

/// `$` at the end of a line.
[[nodiscard]] bool endsInDollar(std::string_view line);

}  // namespace arelem::frontend
