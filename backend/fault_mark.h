#pragma once
#include <cstdint>
#include <optional>

#include "ir/space/vector.h"

namespace arelem::backend {

/// A motion that could not be computed, for pictures of programs with errors.
struct FaultMark {
  std::uint32_t line = 0;     ///< of its statement
  Vec3 place = Vec3::Zero();  ///< where the tool stood
  std::optional<Vec3> next;   ///< where the next motion that could be computed went from there
};

}  // namespace arelem::backend
