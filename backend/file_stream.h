#pragma once
#include <array>
#include <cstdint>
#include <streambuf>

namespace arelem::backend {

/// An output stream buffer over a file descriptor that remembers why writing failed. Does not own
/// it.
class FileStreamBuffer : public std::streambuf {
 public:
  explicit FileStreamBuffer(int descriptor);

  /// errno of the first failure, or 0. After a failure nothing more is written.
  [[nodiscard]] int error() const { return error_; }
  [[nodiscard]] std::uint64_t written() const { return written_; }

 protected:
  int_type overflow(int_type byte) override;
  std::streamsize xsputn(const char* bytes, std::streamsize count) override;
  int sync() override;

 private:
  bool flushBlock();
  bool writeAll(const char* bytes, std::size_t count);

  int descriptor_;
  int error_ = 0;
  std::uint64_t written_ = 0;
  std::array<char, 65536> block_{};
};

}  // namespace arelem::backend
