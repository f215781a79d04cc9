#pragma once
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <string_view>

namespace arelem::backend {

/// Collects bytes and hands full blocks to a stream: a stream call costs more than a number.
class OutBuffer {
 public:
  explicit OutBuffer(std::ostream& out);
  OutBuffer(const OutBuffer&) = delete;
  OutBuffer& operator=(const OutBuffer&) = delete;

  void append(std::string_view bytes);
  void append(char byte) {
    char* place = room(1);
    *place = byte;
    filled(place + 1);
  }
  /// At least `size` (at most blockSize) bytes to write into; `filled` then tells how far they were
  /// used.
  char* room(std::size_t size);
  void filled(const char* end) { used_ = static_cast<std::size_t>(end - block_.get()); }
  /// Hands the rest to the stream and flushes it.
  void finish();

  static constexpr std::size_t blockSize = std::size_t{1} << 18;

 private:
  void flush();
  std::ostream& out_;
  std::unique_ptr<char[]> block_;
  std::size_t used_ = 0;
};

}  // namespace arelem::backend
