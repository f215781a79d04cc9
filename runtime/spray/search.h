#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "ir/limits.h"
#include "runtime/spray/passes.h"

namespace arelem::spray {

/// What stays the same while size and angle are searched.
struct Task {
  Outline outline;
  double film = 0.0;    ///< wanted mean film, mm
  double aspect = 1.0;  ///< along / across of the footprint
  double overlap = 0.0;
  double insetRatio = 0.0;  ///< c / b
  StopRule stop = StopRule::strict;
  double sharpest = PassRules::mitreLimit;
  double shortestGap = 0.0;
  double leadOn = 0.0;  ///< the gun is switched on so much earlier, s
  std::uint64_t mostPasses = arelem::Limits{}.passes;
  GunLimits limits;
  Prices prices;
};

/// Rules of the passes for one size of the footprint.
[[nodiscard]] PassRules rulesFor(const Task& task, double across);

/// One pair of size and angle.
struct Trial {
  double across = 0.0;     ///< b, mm
  double degrees = 0.0;    ///< of the passes
  bool complete = true;    ///< false: more passes than the task allows
  bool preferred = false;  ///< b fits a whole number of passes into the height of the work
  std::size_t passes = 0;
  PathLengths lengths;
  Operation operation;
  Cost cost;
};
[[nodiscard]] Trial evaluate(const Task& task, double across, double degrees);

/// A range of values: from, from + step, ... as far as `to`.
struct Range {
  double from = 0.0, to = 0.0, step = 0.0;
  [[nodiscard]] std::vector<double> values() const;
};

/// Sizes that fit n whole intervals into a height: b = H / (2 [(n - 1)(1 - beta) + u]), u = c / b.
/// The source's (4.38) has 2 u, its (4.39) and (4.40) lost + 1.
[[nodiscard]] double preferredSize(double height, double overlap, double insetRatio, int passes);
/// Number of passes for a size, a real number.
[[nodiscard]] double passesFor(double height, double overlap, double insetRatio, double across);
[[nodiscard]] std::vector<double> preferredSizes(
    double height,
    double overlap,
    double insetRatio,
    double smallest,
    double largest,
    std::uint64_t mostPasses = arelem::Limits{}.passes);

/// What a search looks at, at most: no angle makes the work higher than it is wide across corners.
struct SearchSize {
  double sizes = 0.0, angles = 0.0;
  double trials = 0.0;  ///< with preferred sizes
  double passes = 0.0;  ///< of all trials
};
[[nodiscard]] SearchSize sizeOfSearch(const Task& task,
                                      const Range& sizes,
                                      const Range& angles,
                                      bool preferredToo);

struct SearchResult {
  std::vector<Trial> trials;  ///< by angle, then size
  std::size_t best = 0;       ///< least cost; equal costs: smaller angle, then smaller size
  bool complete = true;       ///< false after an interrupt
};

/// How far a search is: `done` of `all` angles. Called from one thread at a time.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// Every size at every angle, and at every angle its preferred sizes too if asked for. Runs on all
/// processors; the result does not depend on their number. Trials that are not complete are not
/// the best unless all are.
[[nodiscard]] SearchResult search(const Task& task,
                                  const Range& sizes,
                                  const Range& angles,
                                  bool preferredToo,
                                  const InterruptFlag* interrupted,
                                  const Progress& progress);

}  // namespace arelem::spray
