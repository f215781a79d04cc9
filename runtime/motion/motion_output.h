#pragma once
#include <algorithm>
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
    if (used_ == room_) {
      makeRoom();
    }
    double* place = waiting_.data() + used_;
    place = std::copy_n(toolEnd.data(), 3, place);
    if (withAxis_) {
      place = std::copy_n(axis.data(), 3, place);
    }
    used_ = static_cast<std::size_t>(place - waiting_.data());
  }
  /// The motion has succeeded.
  void commit();

 private:
  static constexpr std::size_t mostWaiting = 1U << 16;  ///< locations
  static constexpr std::size_t firstRoom = 384;         ///< numbers, of whole locations
  [[nodiscard]] std::size_t most() const { return (withAxis_ ? 6U : 3U) * mostWaiting; }
  void makeRoom();
  void release();

  RecordWriter& writer_;
  const runtime::Follow* motion_ = nullptr;
  bool visible_ = true, withAxis_ = false, started_ = false;
  std::vector<double> waiting_;  ///< as in a record, one location after another
  std::size_t used_ = 0;         ///< numbers of them that are
  std::size_t room_ = 0;         ///< up to which number there is room
};

}  // namespace arelem::motion
