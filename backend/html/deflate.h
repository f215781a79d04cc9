#pragma once
#include <span>
#include <vector>

namespace arelem::backend {

/// Bytes as a stream of zlib (RFC 1950), which browsers read as "deflate". The same bytes for the
/// same input and the same library.
[[nodiscard]] std::vector<unsigned char> deflated(std::span<const unsigned char> bytes);

}  // namespace arelem::backend
