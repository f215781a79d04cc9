#pragma once
#include <ostream>
#include <span>
#include <vector>

namespace arelem::backend {

/// Bytes as base64 with padding, without line breaks.
void writeBase64(std::ostream& out, std::span<const unsigned char> bytes);

template <class T>
void writeBase64(std::ostream& out, const std::vector<T>& values) {
  writeBase64(out, {reinterpret_cast<const unsigned char*>(values.data()),  // NOLINT: their bytes
                    values.size() * sizeof(T)});
}

}  // namespace arelem::backend
