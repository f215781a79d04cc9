#pragma once
#include <string>

namespace arelem::backend {

/// The name of a file that must not survive the process. Removed with the object, or by `removeAll`
/// from whatever place the process ends at.
class TemporaryFile {
 public:
  /// "" names no file.
  explicit TemporaryFile(std::string path);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// The file was renamed or is no longer temporary.
  void release();
  /// Removes every temporary file of the process; safe to call from any thread.
  static void removeAll();

 private:
  std::string path_;
};

}  // namespace arelem::backend
