#pragma once
#include <string>

namespace arelem::app {

/// `name.png`, or `name_2.png` for the second of several statements.
[[nodiscard]] std::string numbered(const std::string& path, std::size_t index, std::size_t count);

}  // namespace arelem::app
