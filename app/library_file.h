#pragma once
#include <string>

#include "app/settings.h"

#include "ir/diag/result.h"

namespace arelem::app {

struct LibraryFile {
  std::string text;
  std::string name;  ///< as messages show it
};

/// A file by its path, or by its name in the folders of -I and of the standard library.
[[nodiscard]] Result<LibraryFile> readLibraryFile(const std::string& name,
                                                  const Settings& settings);

}  // namespace arelem::app
