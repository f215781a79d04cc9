#pragma once
#include <algorithm>
#include <optional>

#include "runtime/motion/effort.h"
#include "runtime/motion/follow.h"
#include "runtime/motion/path.h"

namespace arelem::motion {

/// Cut vectors on their way to the output and into the statistics. The last one can be held back,
/// for a stop that may take the place of its end.
class Trail {
 public:
  Trail(const Path& path, FollowResult& result, CutVectorSink& sink, Effort& effort)
      : path_(path), result_(result), sink_(sink), effort_(effort) {}

  /// The cut vector that follows.
  void put(const PathPoint& from, const PathPoint& to) {
    release();
    effort_.allow(++result_.cutVectors);
    write(from, to);
  }
  void hold(const PathPoint& from, const PathPoint& to) {
    release();
    effort_.allow(++result_.cutVectors);
    held_ = Held{from, to};
  }
  [[nodiscard]] std::uint64_t count() const { return result_.cutVectors; }
  /// Where the cut vector that is held back began.
  [[nodiscard]] std::optional<PathPoint> heldFrom() const {
    return held_ ? std::optional(held_->from) : std::nullopt;
  }
  /// It shall not be.
  void withdraw() {
    held_.reset();
    --result_.cutVectors;
  }
  void release() {
    if (held_) {
      write(held_->from, held_->to);
      held_.reset();
    }
  }

 private:
  struct Held {
    PathPoint from, to;
  };
  void write(const PathPoint& from, const PathPoint& to) {
    const Vec3 step = to.toolEnd - from.toolEnd;
    const double length = step.norm();
    result_.length += length;
    sink_.put(to.toolEnd, to.axis);
    result_.partInner = std::min(result_.partInner, to.contacts[0].gap);
    result_.partOuter = std::max(result_.partOuter, to.contacts[0].gap);
    result_.driveInner = std::min(result_.driveInner, to.contacts[1].gap);
    result_.driveOuter = std::max(result_.driveOuter, to.contacts[1].gap);
    // One within the bands may go from one of their sides to the other, whatever the path does.
    result_.forward = length > path_.band() ? step : to.tangent;
  }

  const Path& path_;
  FollowResult& result_;
  CutVectorSink& sink_;
  Effort& effort_;
  std::optional<Held> held_;
};

}  // namespace arelem::motion
