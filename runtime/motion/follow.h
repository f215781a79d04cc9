#pragma once
#include <vector>

#include "ir/limits.h"
#include "runtime/motion/check_watch.h"
#include "runtime/motion/state.h"

/// One motion along a drive and a part surface up to a check surface (ARLM3 and ARLM2 of the old
/// system).
namespace arelem::motion {

struct CheckGoal {
  NamedSurface surface;
  ir::Condition condition = ir::Condition::to;
  int nth = 1;
  bool onByDefault = false;  ///< implied, and ON because no tool position word was given
};

struct FollowRequest {
  ir::Heading heading = ir::Heading::forward;
  NamedSurface drive;
  std::vector<CheckGoal> checks;  ///< at least one
};

struct FollowResult {
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  Vec3 forward = Vec3::UnitX();  ///< of the last cut vector
  std::size_t check = 0;         ///< index of the check surface that was met
  std::uint64_t cutVectors = 0;
  double length = 0.0;
  double driveInner = 0.0, driveOuter = 0.0, partInner = 0.0, partOuter = 0.0;
  std::vector<Failure> warnings;
};

/// Receives every cut vector's end point and tool axis, in order.
class CutVectorSink {
 public:
  virtual ~CutVectorSink() = default;
  virtual void put(const Vec3& toolEnd, const Vec3& axis) = 0;
};

/// For motions that are computed for the sake of what is told of them.
class NoSink final : public CutVectorSink {
 public:
  void put(const Vec3& /*toolEnd*/, const Vec3& /*axis*/) override {}
};

/// Runs the motion from the state's tool position; does not change the state.
[[nodiscard]] Result<FollowResult> follow(const State& state,
                                          const FollowRequest& request,
                                          CutVectorSink& sink,
                                          const Limits& limits,
                                          const InterruptFlag* interrupted);

}  // namespace arelem::motion
