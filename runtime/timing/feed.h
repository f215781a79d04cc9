#pragma once
#include <optional>

#include "ir/cl/feed.h"
#include "ir/diag/diagnostic.h"

namespace arelem::timing {

/// The feed in force, as FEDRAT and SPINDL say.
class FeedInForce {
 public:
  void setUnit(double millimeters) { unit_ = millimeters; }
  /// Other statements than these two change nothing, nor do those that objectionToTiming refuses.
  void take(const cl::Post& post);
  /// mm a minute along a move of this length, mm; 0 where no feed is known.
  [[nodiscard]] double perMinute(double length) const { return feed_.perMinute(length, turns_); }
  /// Whether the feed counts moves a minute.
  [[nodiscard]] bool isInverse() const { return feed_.per == cl::Feed::Per::move; }
  /// Whether the feed is per turn, and the spindle has no speed.
  [[nodiscard]] bool lacksSpindle() const {
    return feed_.per == cl::Feed::Per::turn && feed_.value > 0.0 && !(turns_ > 0.0);
  }
  /// Of the spindle, a minute.
  [[nodiscard]] double turns() const { return turns_; }

 private:
  double unit_ = 1.0;  // mm
  cl::Feed feed_;
  double turns_ = 0.0;
};

/// Why no time follows from a FEDRAT or a DELAY: it is not one number, with one of the units that
/// cl::readFeed knows, or with REV. None for other statements. The row is E0598.
[[nodiscard]] std::optional<Failure> objectionToTiming(const cl::Post& post);

}  // namespace arelem::timing
