#include "backend/html/base64.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace arelem::backend {

static_assert(std::endian::native == std::endian::little, "the page reads little endian arrays");

void writeBase64(std::ostream& out, std::span<const unsigned char> bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr std::size_t block = 3 * 1024;
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      group = group << 8U | (i < n ? bytes[at + i] : 0U);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      text += i <= n ? letters[group >> (18U - 6U * i) & 63U] : '=';
    }
    if (at % block == 0) {
      out << text;
      text.clear();
    }
  }
  out << text;
}

}  // namespace arelem::backend
