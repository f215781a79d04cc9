#pragma once
#include <ostream>
#include <string>

namespace arelem::app {

/// Draws an SVG picture as PNG, `width` pixels wide. False when that fails.
[[nodiscard]] bool writePng(std::ostream& out, const std::string& svg, int width);

}  // namespace arelem::app
