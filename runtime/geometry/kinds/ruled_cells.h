#pragma once
#include <algorithm>
#include <array>

/// The parts of a ruling that carry bounds of a ruled surface. Private to runtime/geometry/kinds.
namespace arelem::surface {

/// Cells for each distance of the curves, from some of those before the first to as many behind the
/// last; and wider ones farther off: motions run on there along the rulings, which have no end.
inline constexpr int cellsOfARuling = 4;
inline constexpr int rulingsBeside = 3;
inline constexpr std::array farEdges{3.0, 3.5, 4.0, 5.0, 6.0, 8.0, 10.0};
inline constexpr int farCells = static_cast<int>(farEdges.size()) - 1;
inline constexpr int nearCells = cellsOfARuling * (1 + 2 * rulingsBeside);
inline constexpr int cellsOfARow = nearCells + 2 * farCells;

struct Cell {
  double middle, half;  ///< of its shares g of the ruling
};
[[nodiscard]] constexpr Cell cellOf(int number) {
  const int near = number - farCells;
  if (near >= 0 && near < nearCells) {
    return {(near + 0.5) / cellsOfARuling - rulingsBeside, 0.5 / cellsOfARuling};
  }
  const auto far = static_cast<std::size_t>(near < 0 ? -1 - near : near - nearCells);
  const double middle = 0.5 * (farEdges[far] + farEdges[far + 1]);
  return {near < 0 ? -middle : 1.0 + middle, 0.5 * (farEdges[far + 1] - farEdges[far])};
}
/// The number of the cell of g; -1 or cellsOfARow beyond all.
[[nodiscard]] inline int cellAt(double g) {
  const double near = (g + rulingsBeside) * cellsOfARuling;
  if (near >= 0.0 && near < nearCells) {
    return farCells + static_cast<int>(near);
  }
  const double away = g < 0.0 ? -g : g - 1.0;
  int far = 0;
  while (far < farCells && !(away < farEdges[static_cast<std::size_t>(far) + 1])) {
    ++far;
  }
  return g < 0.0 ? farCells - 1 - far : farCells + nearCells + far;
}

}  // namespace arelem::surface
