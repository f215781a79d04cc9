#pragma once
#include <vector>

#include "runtime/spray/sprayed.h"

/// The film that a gun leaves, computed place by place.
namespace arelem::film {

/// How a film lies about the wanted one, over what is to be painted. R1, R2, R3 as in
/// spray::Uniformity, but about the wanted film and with edges and ends.
struct Statistics {
  double wanted = 0.0;                               ///< mm
  double mean = 0.0, smallest = 0.0, largest = 0.0;  ///< mm
  spray::Uniformity spread;
  double within10 = 0.0;   ///< share of the area within 10 % of the wanted film
  double astray = 0.0;     ///< share with less than half or more than twice the wanted film
  double area = 0.0;       ///< mm2, of the cells that count
  double deposited = 0.0;  ///< on the work, mm3
  double outside = 0.0;    ///< beside it, mm3
};

/// Film in the plane of a region, in square cells, row by row from the lowest y.
struct Map {
  spray::Vec2 low = spray::Vec2::Zero();  ///< corner of the first cell, mm
  double cell = 1.0;                      ///< mm
  std::size_t columns = 0, rows = 0;
  std::vector<double> film;   ///< mm, at the middle of each cell
  std::vector<bool> onWork;   ///< whether the middle of the cell is to be painted
  std::vector<double> areas;  ///< of the work under each cell, mm2; empty: cell by cell
  Statistics statistics;

  [[nodiscard]] spray::Vec2 middle(std::size_t column, std::size_t row) const {
    return low +
           cell * spray::Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
  }
  [[nodiscard]] double at(std::size_t column, std::size_t row) const {
    return film[row * columns + column];
  }
};

/// The film at one place of the plane (mm), exact for straight strokes and a footprint whose
/// density is uniform along the travel: q eta / (v b) p(w / b) times the share of the footprint's
/// chord that passed over the place.
[[nodiscard]] double filmAt(const spray::Sprayed& sprayed, const spray::Vec2& place);

/// The map over the region and what is sprayed beside it, with cells of this size (mm); 0 gives
/// about `usualCells` in the longer direction, more where passes are narrow.
inline constexpr double usualCells = 400.0;
inline constexpr double mostUsualCells = 2000.0;
inline constexpr double cellsOfPass = 8.0;  ///< in the half width of the footprint
inline constexpr std::size_t mostCells = 100'000'000;
[[nodiscard]] Map mapOf(const spray::Sprayed& sprayed, double cell);

/// Fills in the statistics over the cells on the work.
void measure(Map& map, double wanted);

}  // namespace arelem::film
