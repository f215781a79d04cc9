#include "frontend/expand/library.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "ir/diag/frontend.h"
#include "ir/text/find_file.h"

namespace arelem::frontend {

namespace {
namespace fs = std::filesystem;
constexpr std::size_t deepest = 32;  // texts that include each other

std::string changed(std::string_view name, bool toLower) {
  std::string result(name);
  for (char& c : result) {
    const auto u = static_cast<unsigned char>(c);
    c = static_cast<char>(toLower ? std::tolower(u) : std::toupper(u));
  }
  return result;
}
}  // namespace

std::optional<BufferId> Library::read(const fs::path& path, std::string_view name, const Span& at) {
  std::error_code error;
  const std::string canonical = path.string();
  for (const BufferId open : open_) {
    const fs::path other = fs::weakly_canonical(fs::path(context_.sources.name(open)), error);
    if (!error && other == path) {
      context_.report(diagnose(at, diag::IncludeCycle, name));
      return std::nullopt;
    }
  }
  if (open_.size() >= deepest) {
    context_.reporter.limit(at, "depth", deepest, "texts that include each other");
    return std::nullopt;
  }
  if (!fs::is_regular_file(path, error)) {
    context_.report(
        diagnose(at, diag::IncludeUnreadable, name, error ? error.message() : "it is not a file"));
    return std::nullopt;
  }
  if (fs::file_size(path, error) > context_.options.limits.bytes) {
    context_.reporter.limit(at, "bytes", context_.options.limits.bytes, "bytes of one source file");
    return std::nullopt;
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) {
    context_.report(diagnose(at, diag::IncludeUnreadable, name, "reading failed"));
    return std::nullopt;
  }
  return context_.sources.add(canonical, std::move(text).str());
}

std::optional<BufferId> Library::loadNamed(std::string_view name, const Span& at) {
  std::error_code error;
  for (const std::string& folder : context_.options.libraryPath) {
    for (const bool lower : {true, false}) {
      const fs::path path =
          fs::weakly_canonical(fs::path(folder) / (changed(name, lower) + ".apt"), error);
      if (!error && fs::exists(path, error)) {
        return read(path, name, at);
      }
    }
  }
  context_.report(diagnose(at, diag::LibraryNotFound, name));
  return std::nullopt;
}

std::optional<BufferId> Library::loadFile(std::string_view name, BufferId from, const Span& at) {
  std::vector<std::string> folders = {fs::path(context_.sources.name(from)).parent_path().string()};
  folders.insert(folders.end(), context_.options.libraryPath.begin(),
                 context_.options.libraryPath.end());
  const Found found = findInside(name, folders);
  if (found.state == Found::State::inside) {
    return read(found.path, name, at);
  }
  context_.report(found.state == Found::State::refused
                      ? diagnose(at, diag::IncludeRefused, name)
                      : diagnose(at, diag::IncludeUnreadable, name, "no such file"));
  return std::nullopt;
}

}  // namespace arelem::frontend
