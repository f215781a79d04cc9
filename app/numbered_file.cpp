#include "app/numbered_file.h"

#include <filesystem>

#include <fmt/format.h>

namespace arelem::app {

std::string numbered(const std::string& path, std::size_t index, std::size_t count) {
  if (count == 1) {
    return path;
  }
  std::filesystem::path numbered(path);
  numbered.replace_filename(
      fmt::format("{}_{}{}", numbered.stem().string(), index + 1, numbered.extension().string()));
  return numbered.string();
}

}  // namespace arelem::app
