#pragma once
#include <span>
#include <string>
#include <string_view>

#include "frontend/complete/complete.h"

namespace arelem::app::repl {

/// A statement or command as it is typed, with the colors of a terminal: words of the language,
/// names that the session has, numbers, texts and comments. Without its color codes it is the line.
[[nodiscard]] std::string highlighted(std::string_view line,
                                      std::span<const frontend::KnownName> names);

}  // namespace arelem::app::repl
