#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace arelem {

/// Where a file that a program names was found.
struct Found {
  enum class State : std::uint8_t {
    inside,   ///< it exists at `path`
    absent,   ///< in none of the folders
    refused,  ///< the name is absolute, empty or leads out of a folder
  };
  State state = State::absent;
  std::filesystem::path path;
};

/// Looks for `name` in the folders in order; "" is the current folder. No name leads out of the
/// folder that it is looked for in, not even over a symbolic link.
[[nodiscard]] Found findInside(std::string_view name, std::span<const std::string> folders);

}  // namespace arelem
