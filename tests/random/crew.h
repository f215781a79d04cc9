#pragma once
#include <span>
#include <vector>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// Tries scenes on several threads.
class Crew {
 public:
  explicit Crew(unsigned threads);
  [[nodiscard]] std::size_t threads() const { return threads_; }
  /// The findings, in the order of the scenes.
  [[nodiscard]] std::vector<Finding> tryAll(std::span<const SceneId> ids);

 private:
  std::size_t threads_;
};

}  // namespace arelem::scenes
