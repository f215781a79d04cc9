#pragma once
#include <string_view>

namespace arelem::backend {

/// The parts of the viewer, put into the binary at build time: a page with the marks <!--STYLE-->,
/// <!--DATA--> and <!--SCRIPT-->.
[[nodiscard]] std::string_view viewerPage();
[[nodiscard]] std::string_view viewerStyle();
[[nodiscard]] std::string_view viewerScript();

}  // namespace arelem::backend
