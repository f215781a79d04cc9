#pragma once
#include <string>

#include "app/settings.h"

#include "ir/diag/result.h"

namespace arelem::app {

struct LibraryFile {
  std::string text;
  std::string name;  ///< as messages show it
};

/// A file by its path, or by its name in the folders of -I and of the standard library and in the
/// shelf of each: a folder inside it, such as `machines`.
[[nodiscard]] Result<LibraryFile> readLibraryFile(const std::string& name,
                                                  const Settings& settings,
                                                  const std::string& shelf = "");

}  // namespace arelem::app
