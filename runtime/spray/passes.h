#pragma once
#include <vector>

#include "ir/limits.h"
#include "runtime/spray/cost.h"
#include "runtime/spray/offset.h"

namespace arelem::spray {

/// When the last pass is found.
enum class StopRule : std::uint8_t {
  strict,   ///< (3.5): one pass more while its height is above y_f - s, y_f = ymin + c
  program,  ///< the source's program: while its height is at or above y_f - s
};

struct PassRules {
  Footprint footprint;
  double overlap = 0.0;  ///< beta, 0 <= beta < 1
  double inset = 0.0;    ///< c, mm
  StopRule stop = StopRule::strict;
  double sharpest = mitreLimit;  ///< of corners, see SprayedArea
  double runUp = 0.0;            ///< before a painted piece at its speed, mm
  double shortestGap = 0.0;      ///< a gap below this is painted over, mm (compress_path)
  std::uint64_t mostPasses = arelem::Limits{}.passes;
  static constexpr double mitreLimit = 4.0;
};

/// One straight pass in the order of travel: hits[0] on, hits[1] off, ...
struct Pass {
  double height = 0.0;
  std::vector<double> hits;
};

struct PassPlan {
  std::vector<Pass> passes;
  double interval = 0.0;  ///< s = 2 b (1 - beta), mm
  PathLengths lengths;
  bool complete = true;  ///< false: more passes than the rules allow; then there are none
};

/// Horizontal passes over an outline from the top down, the first to the right, alternating.
/// Source: Bartlett 3.2 with the corrections of formulas 1.
[[nodiscard]] PassPlan planPasses(const Outline& outline, const PassRules& rules);

/// Closes gaps shorter than `gap` between intervals in order (compress_path; the listing ignores
/// its argument).
[[nodiscard]] std::vector<Interval> withoutGaps(const std::vector<Interval>& intervals, double gap);

}  // namespace arelem::spray
