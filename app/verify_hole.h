#pragma once
#include <optional>
#include <span>
#include <string>

#include "app/verify_path.h"

namespace arelem::app {

/// What the moves at one hole come to.
struct HoleRead {
  std::size_t moves = 0;  ///< that belong to it
  std::string fault;      ///< "" for none
};

/// Reads the moves of one hole without knowledge of who wrote them: never below the clearance
/// before the tool stands over the hole, then along its axis only, into whole material with the
/// feed and no deeper at once than a peck, to the depth and no deeper, the wait there, and back to
/// the clearance, with the feed where the cycle bores. Lengths in the part unit.
[[nodiscard]] HoleRead readHole(const Location& hole,
                                std::span<const Location> moves,
                                const Allowed& allowed);

}  // namespace arelem::app
