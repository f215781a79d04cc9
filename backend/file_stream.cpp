#include "backend/file_stream.h"

#include <cerrno>

#include <unistd.h>

namespace arelem::backend {

FileStreamBuffer::FileStreamBuffer(int descriptor) : descriptor_(descriptor) {
  setp(block_.data(), block_.data() + block_.size());
}

FileStreamBuffer::int_type FileStreamBuffer::overflow(int_type byte) {
  if (!flushBlock()) {
    return traits_type::eof();
  }
  if (!traits_type::eq_int_type(byte, traits_type::eof())) {
    *pptr() = traits_type::to_char_type(byte);
    pbump(1);
  }
  return traits_type::not_eof(byte);
}

std::streamsize FileStreamBuffer::xsputn(const char* bytes, std::streamsize count) {
  if (count < epptr() - pptr()) {
    traits_type::copy(pptr(), bytes, static_cast<std::size_t>(count));
    pbump(static_cast<int>(count));
    return count;
  }
  return flushBlock() && writeAll(bytes, static_cast<std::size_t>(count)) ? count : 0;
}

int FileStreamBuffer::sync() {
  return flushBlock() ? 0 : -1;
}

bool FileStreamBuffer::flushBlock() {
  const bool good = writeAll(pbase(), static_cast<std::size_t>(pptr() - pbase()));
  setp(block_.data(), block_.data() + block_.size());
  return good;
}

bool FileStreamBuffer::writeAll(const char* bytes, std::size_t count) {
  while (count > 0 && error_ == 0) {
    const ssize_t done = ::write(descriptor_, bytes, count);
    if (done < 0) {
      error_ = errno == EINTR ? 0 : errno;
      continue;
    }
    bytes += done;
    count -= static_cast<std::size_t>(done);
    written_ += static_cast<std::uint64_t>(done);
  }
  return error_ == 0;
}

}  // namespace arelem::backend
