#include "runtime/motion/facts.h"

namespace arelem::motion {

void Facts::add(const runtime::Action& action,
                const char* statement,
                std::uint64_t cutVectors,
                double length,
                const FollowResult* follow,
                const State& after,
                Instant since) {
  ++outcome_.motions;
  outcome_.cutVectors += cutVectors;
  outcome_.length += length;
  if (!keepsEach_ && !traced_) {
    return;
  }
  runtime::MotionFact f;
  f.origin = action.origin;
  f.isn = action.isn;
  f.statement = statement;
  f.cutVectors = cutVectors;
  f.length = length;
  if (follow != nullptr) {
    f.driveInner = follow->driveInner;
    f.driveOuter = follow->driveOuter;
    f.partInner = follow->partInner;
    f.partOuter = follow->partOuter;
  }
  f.traced = traced_;
  f.end = after.toolEnd;
  f.axis = after.axis;
  f.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  outcome_.facts.push_back(std::move(f));
}

runtime::MotionOutcome Facts::take(bool complete) {
  outcome_.complete = complete;
  return std::move(outcome_);
}

}  // namespace arelem::motion
