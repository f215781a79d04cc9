#pragma once
#include <string>
#include <vector>

namespace arelem::backend {

/// Red, green, blue, each 0 to 255.
struct Color {
  unsigned char red = 0, green = 0, blue = 0;
};

/// Pixels row by row from the top as the bytes of a PNG file; empty when the library fails.
[[nodiscard]] std::string pngOf(const std::vector<Color>& pixels, std::size_t width);

}  // namespace arelem::backend
