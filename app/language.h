#pragma once
#include <ostream>
#include <string_view>

namespace arelem::app {

/// The definition forms of a noun, or the statements with a word (upper case); false when there are
/// none.
bool printLanguage(std::ostream& out, std::string_view word);

}  // namespace arelem::app
