#pragma once
#include <string>
#include <string_view>

namespace arelem::app {

/// The SHA-256 of some bytes in 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace arelem::app
