#include "runtime/motion/motion_output.h"

namespace arelem::motion {

void MotionOutput::begin(const runtime::Follow& motion, bool visible, bool withAxis) {
  motion_ = &motion;
  visible_ = visible;
  withAxis_ = withAxis;
  started_ = false;
  used_ = 0;
  room_ = std::min(waiting_.size(), most());
}

void MotionOutput::makeRoom() {
  if (used_ == most()) {
    return release();
  }
  waiting_.resize(std::min(std::max(2 * waiting_.size(), firstRoom), most()));
  room_ = waiting_.size();
}

/// The circle that the points run along, the feed from here on, the points.
void MotionOutput::release() {
  const Entity& drive = *motion_->drive;
  if (!started_) {
    const bool round = drive.type == EntityType::circle || drive.type == EntityType::cylinder;
    if (visible_ && round) {
      cl::Surface s;
      s.surface = {drive.type, drive.name, drive.subscript, drive.canon};
      writer_.put(std::move(s));
    }
    if (motion_->feed) {
      writer_.putFeed(*motion_->feed);
    }
    if (visible_) {
      writer_.startPoints(cl::Motion::Kind::go, drive.name, drive.subscript, withAxis_);
    }
    started_ = true;
  }
  if (visible_) {
    writer_.add({waiting_.data(), used_});
  }
  used_ = 0;
}

void MotionOutput::commit() {
  release();
  if (visible_) {
    writer_.finishPoints();
  }
}

}  // namespace arelem::motion
