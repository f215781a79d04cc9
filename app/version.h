#pragma once
#include <string>

namespace arelem::app {

/// "0.1.0": what reports carry, so that builds of one release write the same bytes.
[[nodiscard]] std::string releaseText();

/// "0.1.0", with the commit of the build where it is known: "0.1.0 (1a2b3c4)". Never part of an
/// output file.
[[nodiscard]] std::string versionText();

}  // namespace arelem::app
