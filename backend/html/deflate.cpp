#include "backend/html/deflate.h"

#include <algorithm>
#include <array>
#include <new>

#include <zlib.h>

namespace arelem::backend {

namespace {
constexpr int level = 6;
constexpr std::size_t piece = std::size_t{1} << 30U;  // zlib counts in 32 bits
}  // namespace

std::vector<unsigned char> deflated(std::span<const unsigned char> bytes) {
  z_stream stream{};
  if (deflateInit(&stream, level) != Z_OK) {
    throw std::bad_alloc();
  }
  std::vector<unsigned char> result;
  std::array<unsigned char, 1U << 16U> buffer{};
  int state = Z_OK;
  do {
    const std::size_t taken = std::min(piece, bytes.size());
    stream.next_in = const_cast<unsigned char*>(bytes.data());  // NOLINT: zlib does not write there
    stream.avail_in = static_cast<uInt>(taken);
    bytes = bytes.subspan(taken);
    do {
      stream.next_out = buffer.data();
      stream.avail_out = static_cast<uInt>(buffer.size());
      state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
      result.insert(result.end(), buffer.begin(), buffer.end() - stream.avail_out);
    } while (stream.avail_out == 0);
  } while (state != Z_STREAM_END);
  deflateEnd(&stream);
  return result;
}

}  // namespace arelem::backend
