#pragma once
#include <variant>

#include "runtime/region/region.h"
#include "runtime/spray/sprayed.h"

namespace arelem::spray {

/// How the inset was asked for: a length in mm, or a rule.
enum class InsetRule : std::uint8_t { edge, mean, program };

/// SPRAY on a region, with every value known. Lengths mm.
struct RegionJob {
  region::Region region;
  double unit = 1.0;  ///< mm in a unit of the region's coordinates
  Gun gun;
  double film = 0.0;
  std::variant<double, Measure> overlap = Measure::average;
  std::variant<double, InsetRule> inset = InsetRule::mean;
  double degrees = 0.0;         ///< of the passes in the region's plane
  std::optional<double> speed;  ///< wanted, mm/s
  bool otherSide = false;       ///< the gun stands on the far side of the normal
  std::optional<Prices> prices;
  std::optional<Range> sizes;   ///< of b, mm
  std::optional<Range> angles;  ///< degrees
  arelem::Limits limits;        ///< of passes, trials and searches
};

struct RegionResult {
  Sprayed sprayed;
  std::vector<Failure> warnings;
};

/// Chooses overlap, inset, size and angle, and plans the passes. Errors: E0353, E0359,
/// E0373 to E0376, E0811.
[[nodiscard]] Result<RegionResult> sprayRegion(const RegionJob& job,
                                               const InterruptFlag* interrupted,
                                               const Progress& progress);

}  // namespace arelem::spray
