#pragma once
#include "ir/cl/post_word.h"
#include "ir/hole/cycle.h"

namespace arelem::path {

/// Whether a cycle is on: each location is then a hole, and between them there is no path that a
/// stage could divide, fit or smooth. A cycle that no control here knows is one too.
class CycleWatch {
 public:
  void take(const cl::Post& post) {
    if (!cl::is(post, Word::CYCLE)) {
      return;
    }
    const Result<hole::Cycles::Change> change = cycles_.read(post);
    if (!change || *change != hole::Cycles::Change::none) {
      on_ = !change || *change != hole::Cycles::Change::ended;
    }
  }
  [[nodiscard]] bool isOn() const { return on_; }

 private:
  hole::Cycles cycles_;
  bool on_ = false;
};

}  // namespace arelem::path
