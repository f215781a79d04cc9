#pragma once
#include <vector>

#include "runtime/motion/follow.h"
#include "runtime/motion/records.h"

namespace arelem::motion {

/// The cut vectors of one motion on their way to the records. They wait until the motion is known
/// to succeed, so that a failed one puts out none; a motion of very many starts to put them out
/// earlier, so that memory stays constant.
class MotionOutput final : public CutVectorSink {
 public:
  explicit MotionOutput(RecordWriter& writer) : writer_(writer) {}

  /// `motion` must outlive the motion; nothing is put out unless `visible` (CUT).
  void begin(const runtime::Follow& motion, bool visible, bool withAxis);
  void put(const Vec3& toolEnd, const Vec3& axis) override {
    if (waiting_.size() == mostWaiting) {
      release();
    }
    waiting_.push_back({toolEnd, axis});
  }
  /// The motion has succeeded.
  void commit();

 private:
  static constexpr std::size_t mostWaiting = 1U << 16;
  struct Location {
    Vec3 toolEnd, axis;
  };
  void release();

  RecordWriter& writer_;
  const runtime::Follow* motion_ = nullptr;
  bool visible_ = true, withAxis_ = false, started_ = false;
  std::vector<Location> waiting_;
};

}  // namespace arelem::motion
