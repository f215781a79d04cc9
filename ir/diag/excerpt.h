#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arelem {

/// A run of bytes of one line to be underlined, with what is to be said there.
struct Mark {
  std::uint32_t begin = 0;  ///< bytes, from the start of the line
  std::uint32_t end = 0;    ///< equal to begin: a place where something is missing
  bool primary = false;     ///< carets instead of dashes, and the excerpt keeps it in view
  std::string text;
};

/// One line of source and the rows below it, without line number.
struct Excerpt {
  std::string source;
  std::vector<std::string> underlines;
};

/// Shows at most `width` columns of the line round its first primary mark; `…` stands for what is
/// cut off. Costs no more than the part that is shown, also on lines of many megabytes.
[[nodiscard]] Excerpt excerpt(std::string_view line,
                              const std::vector<Mark>& marks,
                              std::size_t width);

}  // namespace arelem
