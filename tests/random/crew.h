#pragma once
#include <functional>
#include <span>
#include <vector>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// Tries scenes on several threads. One that takes too long is stopped and counts as failed.
class Crew {
 public:
  explicit Crew(unsigned threads);
  /// The findings, in the order of the scenes.
  [[nodiscard]] std::vector<Finding> tryAll(std::span<const SceneId> ids);

 private:
  unsigned threads_;
};

}  // namespace arelem::scenes
