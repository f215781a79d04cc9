#pragma once
#include <memory>
#include <ostream>
#include <string>

#include "ir/diag/result.h"

namespace arelem::app {

/// An output that is complete or absent. A file appears under its name when it is committed
/// (backend/atomic_file.h); standard output is kept in memory until then, so that nothing of a
/// failed run gets out. Destroyed without commit it leaves nothing behind.
class OutputFile {
 public:
  virtual ~OutputFile() = default;
  [[nodiscard]] virtual std::ostream& stream() = 0;
  /// Everything is on the disk, still under the temporary name. Nothing may be written after it.
  [[nodiscard]] virtual Result<std::uint64_t> complete() = 0;
  /// Gives the result its final name, or `name` + `.partial`.
  [[nodiscard]] virtual Result<std::string> commit(bool partial) = 0;
};

[[nodiscard]] Result<std::unique_ptr<OutputFile>> openOutput(const std::string& path);

}  // namespace arelem::app
