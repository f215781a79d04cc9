#pragma once
#include <array>
#include <string_view>

#include "tests/random/dice.h"
#include "tests/random/shape.h"

namespace arelem::scenes {

/// The kinds of part and drive surface: the rows of the table are their pairs.
inline constexpr std::array<std::string_view, 10> kinds{"plane",     "sphere",  "cylinder", "cone",
                                                        "torus",     "quadric", "tabcyl",   "ruled",
                                                        "polyconic", "mesh"};
inline constexpr std::size_t pairCount = kinds.size() * kinds.size();

/// A surface under the tool near the x axis.
[[nodiscard]] Shape partSurface(std::size_t kind, Dice& dice);
/// A surface that stands along the x axis.
[[nodiscard]] Shape driveSurface(std::size_t kind, Dice& dice);
/// A surface across the x axis.
[[nodiscard]] Shape checkSurface(Dice& dice);

}  // namespace arelem::scenes
