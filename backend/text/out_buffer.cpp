#include "backend/text/out_buffer.h"

#include <cstring>
#include <ostream>

namespace arelem::backend {

OutBuffer::OutBuffer(std::ostream& out)
    : out_(out), block_(std::make_unique_for_overwrite<char[]>(blockSize)) {}

void OutBuffer::append(std::string_view bytes) {
  if (bytes.size() > blockSize - used_) {
    flush();
  }
  if (bytes.size() > blockSize) {
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return;
  }
  std::memcpy(block_.get() + used_, bytes.data(), bytes.size());
  used_ += bytes.size();
}

char* OutBuffer::room(std::size_t size) {
  if (size > blockSize - used_) {
    flush();
  }
  return block_.get() + used_;
}

void OutBuffer::flush() {
  out_.write(block_.get(), static_cast<std::streamsize>(used_));
  used_ = 0;
}

void OutBuffer::finish() {
  flush();
  out_.flush();
}

}  // namespace arelem::backend
