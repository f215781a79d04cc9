#include "app/temporary_files.h"

#include <mutex>
#include <set>

#include <unistd.h>

namespace arelem::app {

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

void rememberTemporary(const std::string& path) {
  const std::lock_guard lock(registry().mutex);
  registry().paths.insert(path);
}

void forgetTemporary(const std::string& path) {
  const std::lock_guard lock(registry().mutex);
  registry().paths.erase(path);
}

void removeTemporary(const std::string& path) {
  const std::lock_guard lock(registry().mutex);
  if (registry().paths.erase(path) != 0) {
    ::unlink(path.c_str());
  }
}

void removeTemporaries() {
  const std::lock_guard lock(registry().mutex);
  for (const std::string& path : registry().paths) {
    ::unlink(path.c_str());
  }
  registry().paths.clear();
}

}  // namespace arelem::app
