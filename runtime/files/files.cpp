#include "runtime/files/files.h"

#include <fstream>

#include "ir/diag/files.h"
#include "ir/text/find_file.h"

namespace arelem::files {

Result<std::string> read(const Files& files, std::string_view name) {
  const Found found = findInside(name, files.folders);
  if (found.state == Found::State::refused) {
    return fail(diag::DataFileRefused, name);
  }
  if (found.state == Found::State::absent) {
    return fail(diag::DataFileUnreadable, name, "no such file")
        .withHelp("data files are looked for beside the part program, then in the folders of -I");
  }
  std::error_code error;
  if (!std::filesystem::is_regular_file(found.path, error)) {
    return fail(diag::DataFileUnreadable, name, error ? error.message() : "it is not a file");
  }
  const std::uintmax_t size = std::filesystem::file_size(found.path, error);
  if (error) {
    return fail(diag::DataFileUnreadable, name, error.message());
  }
  if (size > files.largest) {
    return fail(diag::DataFileTooLarge, name, std::uint64_t{size}, files.largest);
  }
  std::string text(size, '\0');
  std::ifstream in(found.path, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) {
    return fail(diag::DataFileUnreadable, name, "reading failed");
  }
  if (files.opened != nullptr) {
    files.opened->push_back(found.path.string());
  }
  return text;
}

}  // namespace arelem::files
