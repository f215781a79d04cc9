#include "ir/text/find_file.h"

#include <algorithm>
#include <system_error>

namespace arelem {

namespace {
namespace fs = std::filesystem;

bool isInside(const fs::path& file, const fs::path& folder) {
  const auto [f, p] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return f == folder.end() || (std::next(f) == folder.end() && f->empty());
}
}  // namespace

Found findInside(std::string_view name, std::span<const std::string> folders) {
  const fs::path wanted(name);
  if (wanted.is_absolute() || name.empty() || name.find('\0') != std::string_view::npos) {
    return {Found::State::refused, {}};
  }
  std::error_code error;
  for (const std::string& folder : folders) {
    const fs::path root = fs::weakly_canonical(folder.empty() ? "." : folder, error);
    const fs::path path = fs::weakly_canonical(root / wanted, error);
    if (error) {
      continue;
    }
    if (!isInside(path, root)) {
      return {Found::State::refused, {}};
    }
    if (fs::exists(path, error)) {
      return {Found::State::inside, path};
    }
  }
  return {Found::State::absent, {}};
}

}  // namespace arelem
