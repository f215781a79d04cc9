#include "backend/temporary_file.h"

#include <mutex>
#include <set>

#include <unistd.h>

namespace arelem::backend {

namespace {
struct Registry {
  std::mutex mutex;
  std::set<std::string> paths;
};
Registry& registry() {
  static Registry only;
  return only;
}
}  // namespace

TemporaryFile::TemporaryFile(std::string path) : path_(std::move(path)) {
  if (!path_.empty()) {
    const std::lock_guard lock(registry().mutex);
    registry().paths.insert(path_);
  }
}

TemporaryFile::~TemporaryFile() {
  const std::lock_guard lock(registry().mutex);
  if (registry().paths.erase(path_) != 0) {
    ::unlink(path_.c_str());
  }
}

void TemporaryFile::release() {
  const std::lock_guard lock(registry().mutex);
  registry().paths.erase(path_);
}

void TemporaryFile::removeAll() {
  const std::lock_guard lock(registry().mutex);
  for (const std::string& path : registry().paths) {
    ::unlink(path.c_str());
  }
  registry().paths.clear();
}

}  // namespace arelem::backend
