#include "runtime/motion/facets/touch_node.h"

namespace arelem::motion {

TouchHeight* TouchNode::of(std::uint32_t index) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (known_[i].index == index) {
      return &known_[i];
    }
  }
  return nullptr;
}

const TouchHeight& TouchNode::add(const TouchHeight& height) {
  std::size_t place = count_;
  if (count_ < known_.size()) {
    ++count_;
  } else {
    place = best_ == 0 ? 1 : 0;
  }
  known_[place] = height;
  if (count_ == 1 || height.z > known_[best_].z) {
    best_ = place;
  }
  return known_[place];
}

void TouchNode::renumber(std::uint32_t index) {
  known_[0] = highest();
  known_[0].index = index;
  count_ = 1;
  best_ = 0;
}

}  // namespace arelem::motion
