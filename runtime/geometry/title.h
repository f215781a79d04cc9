#pragma once
#include <string>

#include <fmt/format.h>

#include "ir/geometry/entity.h"
#include "ir/words/words.h"

namespace arelem::surface {

/// What messages call an entity: its name, `A(3)` of an array, `(PLANE)` where it has none.
[[nodiscard]] inline std::string titleOf(const Entity& entity) {
  std::string title = entity.name.empty() ? fmt::format("({})", spell(entity.type)) : entity.name;
  if (entity.subscript > 0) {
    title += fmt::format("({})", entity.subscript);
  }
  return title;
}

}  // namespace arelem::surface
