#pragma once
#include <array>
#include <string>
#include <vector>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// What scenes cost, by pair of kinds.
class Times {
 public:
  void add(const Finding& finding) {
    of_[finding.id.pair].push_back({finding.seconds, finding.id});
  }
  /// For each pair: scenes, median, what nine of ten and 99 of 100 do not exceed, the longest one.
  [[nodiscard]] std::string table() const;

 private:
  struct Time {
    double seconds = 0.0;
    SceneId id;
  };
  std::array<std::vector<Time>, pairCount> of_;
};

}  // namespace arelem::scenes
