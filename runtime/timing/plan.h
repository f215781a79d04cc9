#pragma once
#include <limits>
#include <vector>

#include "runtime/timing/transition.h"

namespace arelem::timing {

/// A path as the time law sees it: pieces with a speed limit each, and a limit in each place
/// between two of them (a corner, a stop).
struct SpeedLimits {
  std::vector<double> lengths;  ///< of the pieces, all greater than 0
  std::vector<double> speeds;   ///< limit of each piece, greater than 0
  std::vector<double> corners;  ///< limit at the start of each piece and at the end of the last one
  /// Whether the ends are passed at any speed up to their corner limit; else exactly at it.
  bool freeEnds = false;
};

/// Speed over a path: nodes that are passed without acceleration, and between two of them a rise to
/// a peak, a part at its speed, and a fall. Every speed is within its limit, acceleration and jerk
/// within those of the machine. Looks ahead over the whole path; O(n log n).
class Plan {
 public:
  Plan(SpeedLimits path, const Limits& limits);

  [[nodiscard]] double duration() const { return total_; }
  [[nodiscard]] double length() const { return places_.back(); }
  /// Time of each piece.
  [[nodiscard]] std::vector<double> pieceTimes() const;

  struct State {
    double place, speed, acceleration;
  };
  [[nodiscard]] State at(double t) const;
  [[nodiscard]] std::size_t nodes() const { return intervals_.size() + 1; }

  struct Interval {
    double place = 0.0, length = 0.0, start = 0.0;  ///< start: time
    double from = 0.0, to = 0.0, peak = 0.0, mostSpeed = 0.0;
    Transition rise, fall;
    double cruise = 0.0;  ///< length at the peak

    [[nodiscard]] double duration() const;
    /// Whether a speed is exceeded between two places, measured from the start of the interval.
    [[nodiscard]] bool exceeds(double speed, double a, double b) const;
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] State at(double t) const;
  };

 private:
  Limits limits_;
  std::vector<double> lengths_;
  std::vector<double> places_;
  std::vector<Interval> intervals_;
  double total_ = 0.0;
};

}  // namespace arelem::timing
