#pragma once
#include <functional>
#include <span>
#include <vector>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// Scenes of one pair of kinds that follow each other.
struct Slice {
  SceneId first;
  std::uint64_t count = 1;  ///< at most
  double seconds = 1e9;     ///< of the processor, after which none is begun
};

/// Tries scenes on several threads. One that takes too long is stopped and counts as failed.
class Crew {
 public:
  explicit Crew(unsigned threads);
  /// The findings, in the order of the scenes. Of every slice at least one scene is tried.
  [[nodiscard]] std::vector<Finding> tryAll(std::span<const Slice> slices);

 private:
  unsigned threads_;
};

}  // namespace arelem::scenes
