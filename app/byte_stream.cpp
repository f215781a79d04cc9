#include "app/byte_stream.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/source_file.h"

#include "ir/diag/files.h"

namespace arelem::app {

Result<std::unique_ptr<std::istream>> openBytes(const std::string& path, const Limits& limits) {
  std::error_code error;
  // All that is no readable file of fair size is told by the reading at once.
  if (path == "-" || !std::filesystem::is_regular_file(path, error)) {
    Result<std::string> bytes = readBytes(path, limits);
    if (!bytes) {
      return bytes.takeFailure();
    }
    return std::unique_ptr<std::istream>(std::make_unique<std::istringstream>(*std::move(bytes)));
  }
  if (std::filesystem::file_size(path, error) > limits.bytes) {
    return fail(diag::InputTooLarge, displayName(path), limits.bytes);
  }
  auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*in) {
    return readBytes(path, limits).takeFailure();
  }
  return std::unique_ptr<std::istream>(std::move(in));
}

}  // namespace arelem::app
