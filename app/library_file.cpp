#include "app/library_file.h"

#include <filesystem>

#include "app/library_path.h"
#include "app/source_file.h"

#include "ir/text/find_file.h"

namespace arelem::app {

Result<LibraryFile> readLibraryFile(const std::string& name,
                                    const Settings& settings,
                                    const std::string& shelf) {
  std::vector<std::string> folders;
  const auto add = [&](const std::string& root) {
    folders.push_back(root);
    const std::filesystem::path inner = std::filesystem::path(root) / shelf;
    std::error_code missing;
    if (!shelf.empty() && std::filesystem::is_directory(inner, missing)) {
      folders.push_back(inner.string());
    }
  };
  for (const std::string& root : settings.libraryPath) {
    add(root);
  }
  for (const std::string& root : installedLibrary()) {
    add(root);
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
