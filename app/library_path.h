#pragma once
#include <string>
#include <vector>

namespace arelem::app {

/// Folders of the standard library that exist: `share/arelem/stdlib` beside the folder of an
/// installed binary, `stdlib` beside the build folder of one that is not. Found through the place
/// of the running binary.
[[nodiscard]] std::vector<std::string> installedLibrary();

}  // namespace arelem::app
