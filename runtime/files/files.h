#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"

/// Data files that a part program names in quotes: drawings, meshes, tables of guns.
namespace arelem::files {

/// Where they are looked for, in order; a name never leads out of the folder it is looked for in.
struct Files {
  std::vector<std::string> folders;       ///< that of the part program first; "" is the current one
  std::uint64_t largest = 2'000'000'000;  ///< bytes of one file (`--max-bytes N`)
  std::vector<std::string>* opened = nullptr;  ///< gets the path of each file that is read
};

/// The bytes of the file. Errors: E0730 outside the folders, E0731 unreadable, E0732 too large.
[[nodiscard]] Result<std::string> read(const Files& files, std::string_view name);

}  // namespace arelem::files
