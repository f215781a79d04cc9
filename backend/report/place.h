#pragma once
#include <cstdint>
#include <string>

namespace arelem::backend {

/// A statement of the source, as far as an editor needs it.
struct SourcePlace {
  std::string file;
  std::uint32_t line = 0;  ///< from 1
};

}  // namespace arelem::backend
