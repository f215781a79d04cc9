#include "app/library_path.h"

#include <filesystem>
#include <system_error>

namespace arelem::app {

std::vector<std::string> installedLibrary() {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  std::vector<std::string> found;
  if (error) {
    return found;
  }
  const fs::path above = binary.parent_path().parent_path();
  for (const fs::path& folder : {above / "share" / "arelem" / "stdlib", above / "stdlib"}) {
    if (fs::is_directory(folder, error)) {
      found.push_back(folder.string());
    }
  }
  return found;
}

}  // namespace arelem::app
