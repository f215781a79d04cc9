#pragma once
#include <string>
#include <string_view>

namespace arelem::vplus {

/// Characters of a name that count; longer names are cut silently by the controller.
inline constexpr std::size_t nameLength = 15;
/// Columns of the longest line known to load.
inline constexpr std::size_t longestLine = 148;

/// A program name of a text: lower case, other characters as periods, a letter first.
[[nodiscard]] std::string programName(std::string_view text);
/// A letter, then letters, digits, periods and underscores.
[[nodiscard]] bool isName(std::string_view text);
/// A word of the language, which is no name. Upper case.
[[nodiscard]] bool isKeyword(std::string_view word);

}  // namespace arelem::vplus
