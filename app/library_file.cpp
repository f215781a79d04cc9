#include "app/library_file.h"

#include <filesystem>

#include "app/library_path.h"
#include "app/source_file.h"

#include "ir/text/find_file.h"

namespace arelem::app {

Result<LibraryFile> readLibraryFile(const std::string& name, const Settings& settings) {
  std::vector<std::string> folders = settings.libraryPath;
  for (std::string& folder : installedLibrary()) {
    folders.push_back(std::move(folder));
  }
  std::error_code error;
  const Found found = std::filesystem::exists(name, error) ? Found{} : findInside(name, folders);
  const std::string path = found.state == Found::State::inside ? found.path.string() : name;
  Result<std::string> text = readBytes(path, settings.limits);
  if (!text) {
    return text.takeFailure();
  }
  return LibraryFile{*std::move(text), std::string(displayName(path))};
}

}  // namespace arelem::app
