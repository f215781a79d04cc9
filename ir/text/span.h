#pragma once
#include <compare>
#include <cstdint>

namespace arelem {

/// Names one text held by a SourceMap: a file, standard input, a REPL line.
struct BufferId {
  std::uint32_t index = 0;
  auto operator<=>(const BufferId&) const = default;
};

/// A run of bytes in one buffer. Every token, statement, record and diagnostic carries one.
/// `length` 0 is a place between two bytes (where something is missing).
struct Span {
  BufferId buffer;
  std::uint32_t begin = 0;
  std::uint32_t length = 0;
  auto operator<=>(const Span&) const = default;
  [[nodiscard]] std::uint32_t end() const { return begin + length; }
};

/// The smallest span that covers both; both must lie in the same buffer.
[[nodiscard]] inline Span join(const Span& a, const Span& b) {
  const std::uint32_t begin = a.begin < b.begin ? a.begin : b.begin;
  const std::uint32_t end = a.end() > b.end() ? a.end() : b.end();
  return {a.buffer, begin, end - begin};
}

}  // namespace arelem
