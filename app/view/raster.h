#pragma once
#include <ostream>
#include <string>

namespace arelem::app {

/// Draws an SVG picture as PNG, `width` pixels wide. False when that fails: `pngFault`.
[[nodiscard]] bool writePng(std::ostream& out, const std::string& svg, int width);

/// Why no PNG can be written.
[[nodiscard]] std::string pngFault();

}  // namespace arelem::app
