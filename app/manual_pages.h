#pragma once
#include <span>
#include <string_view>

namespace arelem::app {

/// A page of docs/manual/diagnostics, put into the binary at build time by app/embed_pages.cmake.
struct ManualPage {
  std::string_view code;  ///< "E0312"
  std::string_view text;  ///< Markdown
};
[[nodiscard]] std::span<const ManualPage> manualPages();

}  // namespace arelem::app
