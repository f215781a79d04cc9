#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "ir/diag/result.h"

namespace arelem::backend {

/// A file that appears under its name only when it is complete. The bytes go to a temporary file in
/// the same folder; `commit` brings it to the disk and renames it. Without a commit, or after any
/// failure, the temporary is removed and an older file of that name is as it was. Two processes
/// that write the same name do not meet: the last commit wins as a whole. FIFOs, /dev/null and
/// /dev/stdout are written directly.
class AtomicFile {
 public:
  /// Fails with the system's words when the folder is not there or not writable, when an existing
  /// file is write-protected, and when the name is a folder, a device, a socket or a symbolic link
  /// to nothing.
  [[nodiscard]] static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&&) noexcept;
  AtomicFile& operator=(AtomicFile&&) noexcept;
  ~AtomicFile();

  /// Goes bad at the first byte that cannot be written; `commit` says why.
  [[nodiscard]] std::ostream& stream();
  /// Brings every byte to the disk, still under the temporary name; the number of bytes. Afterwards
  /// the stream must not be used. With several outputs all are completed before the first is
  /// committed.
  [[nodiscard]] Result<std::uint64_t> complete();
  /// Once; completes the file if that was not done and gives it its name, followed by `suffix`.
  [[nodiscard]] std::optional<Failure> commit(const std::string& suffix = "");
  /// Removes the temporaries of all files that are open in this process, for an end without
  /// unwinding. May be called from any thread.
  static void removeTemporaries();

 private:
  struct State;
  explicit AtomicFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace arelem::backend
