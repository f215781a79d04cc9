#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "frontend/check/context.h"

namespace arelem::frontend {

/// Finds and loads the texts that a program names: LIBRY macros, READ/2 segments, INCLUDE files.
/// No path leaves the folder of the including text or the library path.
class Library {
 public:
  explicit Library(Context& context) : context_(context) {}

  /// `<name>.apt` (lower or upper case) in the library path.
  std::optional<BufferId> loadNamed(std::string_view name, const Span& at);
  /// A file named by INCLUDE in the text `from`.
  std::optional<BufferId> loadFile(std::string_view name, BufferId from, const Span& at);
  /// Texts that are being read, outermost first.
  void enter(BufferId buffer) { open_.push_back(buffer); }
  void leave() { open_.pop_back(); }
  [[nodiscard]] std::size_t depth() const { return open_.size(); }

 private:
  std::optional<BufferId> read(const std::filesystem::path& path,
                               std::string_view name,
                               const Span& at);

  Context& context_;
  std::vector<BufferId> open_;
};

}  // namespace arelem::frontend
