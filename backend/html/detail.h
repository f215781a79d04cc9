#pragma once
#include <cstdint>
#include <vector>

#include "backend/html/scene.h"

namespace arelem::backend {

/// What the page leaves out of a long path, so that a picture of it takes few segments. Level 0 has
/// every location, level l only those that lie more than `tolerance(l)` off the chord that would
/// replace them: what is drawn of level l is nowhere further than that from the path.
///
/// Locations are judged in blocks of `blockLength` that follow one another, by the recursion of
/// Ramer (1972) and of Douglas and Peucker (1973); the ends of blocks, and places where the path is
/// broken, belong to all levels. So do the ends of a run of moves of one kind (rapid, feed, gun on)
/// that is longer than the tolerance, on both sides.
struct Detail {
  static constexpr std::size_t blockLength = 1024;
  static constexpr int highest = 13;        ///< level
  static constexpr double finest = 16384.;  ///< size over the tolerance of level 1

  double size = 0.0;                 ///< diagonal of the box of all locations
  std::vector<std::uint8_t> levels;  ///< of each location: the highest that has it
  std::vector<float> boxes;          ///< of each block: low x, y, z, high x, y, z

  /// In the part unit; twice that of the level below.
  [[nodiscard]] double tolerance(int level) const;
};

/// Block b has the locations from b * blockLength to (b + 1) * blockLength, with both ends.
/// `places` has three coordinates a location, `kinds` one SceneMove.
[[nodiscard]] Detail detailOf(const std::vector<double>& places,
                              const std::vector<std::uint8_t>& kinds);

}  // namespace arelem::backend
