#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/random/trial.h"

namespace arelem::scenes {

/// Counts of the scenes run so far, by pair of kinds.
class Table {
 public:
  explicit Table(std::uint64_t seed) : seed_(seed) {}

  /// Reads a table of the same seed; a file that is not there is an empty table. Throws
  /// std::runtime_error for anything else.
  void read(const std::string& path);
  /// From now on scenes are of this commit of the motion.
  void setCommit(const std::string& commit);
  void write(const std::string& path) const;

  void add(const Finding& finding);
  /// Takes back what `add` counted.
  void remove(const Finding& finding);
  [[nodiscard]] std::uint64_t scenes(std::size_t pair) const { return rows_[pair].scenes; }
  [[nodiscard]] std::string summary() const;

 private:
  struct Row {
    std::uint64_t scenes = 0, computed = 0, refused = 0, confirmed = 0, paths = 0, refusals = 0;
    // `paths` and `refusals`: how many failed by them.
    std::map<std::string, std::uint64_t> codes;  ///< of the refusals that are right
  };
  void count(const Finding& finding, std::uint64_t change);

  std::uint64_t seed_;
  std::vector<std::string> commits_;  ///< of the scenes, in their order
  std::array<Row, pairCount> rows_;
};

}  // namespace arelem::scenes
