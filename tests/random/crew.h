#pragma once
#include <functional>
#include <span>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// Tries scenes on several threads.
class Crew {
 public:
  explicit Crew(unsigned threads);
  [[nodiscard]] std::size_t threads() const { return threads_; }
  /// Hands over the findings in the order of the scenes, one at a time, each as soon as those
  /// before it are there: a scene that lasts does not keep the other threads waiting. No scene is
  /// begun after `take` has returned false; those at work are still handed over.
  void tryAll(std::span<const SceneId> ids, const std::function<bool(const Finding&)>& take);

 private:
  std::size_t threads_;
};

}  // namespace arelem::scenes
