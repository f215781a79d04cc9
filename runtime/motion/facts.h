#pragma once
#include <chrono>

#include "runtime/motion/follow.h"
#include "runtime/motion/state.h"
#include "runtime/run.h"

namespace arelem::motion {

/// Sums what the motion statements did and, where it is asked for, keeps the fact of each.
class Facts {
 public:
  using Instant = std::chrono::steady_clock::time_point;

  explicit Facts(bool keepsEach) : keepsEach_(keepsEach) {}

  /// When a statement begins; the clock is not read where nobody wants the answer.
  [[nodiscard]] Instant begin() const {
    return keepsEach_ ? std::chrono::steady_clock::now() : Instant{};
  }
  /// DEBUG: whether the facts from here on are marked.
  void trace(bool on) { traced_ = on; }
  /// `statement` must outlive this. `length` of the path in part units; `follow` may be null.
  void add(const runtime::Action& action,
           const char* statement,
           std::uint64_t cutVectors,
           double length,
           const FollowResult* follow,
           const State& after,
           Instant since);
  /// What was summed and kept.
  [[nodiscard]] runtime::MotionOutcome take(bool complete);

 private:
  bool keepsEach_;
  bool traced_ = false;
  runtime::MotionOutcome outcome_;
};

}  // namespace arelem::motion
