#pragma once
#include <span>

#include "runtime/certify/motion_check.h"

namespace arelem::certify {

/// A motion along a drive and a part surface, proven while its locations come: its memory does not
/// grow with their number. The modal state must stay as it is meanwhile.
class FollowProof {
 public:
  /// `first` is where the motion begins.
  FollowProof(MotionCheck& check,
              const Modal& modal,
              const Named& drive,
              std::span<const Goal> goals,
              const Location& first,
              const InterruptFlag* interrupted);

  void add(const Location& next);
  /// True where the tool is at none of the sides of drive or part surface, by more than another
  /// band.
  [[nodiscard]] bool strays(const Location& at) const;
  /// True where the tool is at neither side of a surface: by more than `most`.
  [[nodiscard]] static bool isOff(const GuideTask& task, const Location& at, double most);
  /// True where the cut vector to `next` would keep the tolerances of drive and part surface.
  [[nodiscard]] bool keeps(const Location& next) { return drive_.keeps(next) && part_.keeps(next); }
  [[nodiscard]] const PathEnd& end() const { return end_; }
  /// False where the path has not come to the goal as often as that asks for.
  [[nodiscard]] bool mayEndAt(std::size_t goal) const {
    return !counts_[goal] || !counts_[goal]->early();
  }
  [[nodiscard]] std::uint64_t cutVectors() const { return cutVectors_; }

  /// What is to be said of the motion, its end at the goal that was met; `met` may lie behind them.
  [[nodiscard]] StatementResult finish(const runtime::Action& action,
                                       std::span<const Goal> goals,
                                       std::size_t met);

 private:
  [[nodiscard]] GuideTask driveTask(const Named& drive) const;
  [[nodiscard]] GuideTask partTask() const;

  MotionCheck& check_;
  const Modal& modal_;
  Location first_;
  GuideStream drive_, part_;
  PathEnd end_;
  std::vector<std::optional<StopCount>> counts_;  ///< of the goals
  Vec3 firstStep_ = Vec3::Zero();
  std::uint64_t cutVectors_ = 0;
  const InterruptFlag* interrupted_;
};

}  // namespace arelem::certify
