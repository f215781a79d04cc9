#pragma once
#include <span>
#include <string_view>

namespace arelem::app {

/// A page of docs/manual, put into the binary at build time by app/embed_pages.cmake.
struct ManualPage {
  std::string_view code;  ///< "E0312" of a diagnostic, "smoothing" of another page
  std::string_view text;  ///< Markdown
};
/// Those of docs/manual/diagnostics.
[[nodiscard]] std::span<const ManualPage> manualPages();
/// Those of docs/manual itself.
[[nodiscard]] std::span<const ManualPage> manualTopics();

}  // namespace arelem::app
