#pragma once
#include <map>
#include <optional>
#include <vector>

#include "runtime/certify/guide.h"
#include "runtime/path/copy_plan.h"

namespace arelem::certify {

/// TRACUT, INDEX and COPY taken back: locations of a CL file as they were before Section 3, and the
/// copies that must follow.
class OutputOrder {
 public:
  /// The locations of one motion as the file has them. Axes count only if the file has some.
  struct Run {
    std::vector<Location> locations;
    bool withAxis = false;
  };

  /// Takes over a TRACUT, INDEX or COPY statement; false for other records. A reason where it
  /// cannot be taken back.
  bool apply(const cl::Body& body, std::string& objection);
  /// A run of the file, as it was programmed.
  [[nodiscard]] Run programmed(const Run& run) const;
  [[nodiscard]] Location programmed(const Location& location) const;
  /// Notes a run of the file for the ranges that are open.
  void keep(const Run& run) { keep(Kept{run, {}}); }
  /// A motion that is no copy comes: no further COPY may take the ranges that were copied as open.
  void goOn();
  /// Whether an INDEX is open, whose runs must be kept for its copies.
  [[nodiscard]] bool keeps() const { return !open_.empty(); }
  /// Whether the file must hold a copy next.
  [[nodiscard]] bool expectsCopy() const {
    return pending_.number <= pending_.plan.times && !pending_.runs.empty();
  }
  /// Number of locations of the next copy.
  [[nodiscard]] std::size_t copyLength() const {
    return pending_.runs[pending_.run].run.locations.size();
  }
  struct Copy {
    Run run;
    std::uint64_t number = 0;  ///< which copy of its COPY, from 1
  };
  /// The next copy, which the open ranges take in as the file is to have it.
  [[nodiscard]] Copy takeCopy();

 private:
  /// A run of a range. `copied`: what the copies inside of the range did to it.
  struct Kept {
    Run run;
    path::Affine copied;
  };
  /// An INDEX. It is open until INDEX/i,NOMORE or the first motion behind its COPY.
  struct Range {
    double index = 0.0;
    std::vector<Kept> runs;
    bool copied = false;
  };
  void keep(const Kept& kept);
  /// Moves the innermost range to the closed ones.
  void closeRange();
  void tracut(const cl::Post& post, std::string& objection);
  void index(const cl::Post& post);
  void copy(const cl::Post& post, std::string& objection);

  /// The copies of the last COPY that are still to come.
  struct Pending {
    std::vector<Kept> runs;
    path::CopyPlan plan;
    std::uint64_t number = 1;
    std::size_t run = 0;
    path::Affine by;
  };

  std::optional<path::Affine> back_;  ///< inverse of the TRACUT matrix in force
  std::vector<Range> open_;           ///< outermost first
  std::map<double, Range> closed_;
  Pending pending_;
};

}  // namespace arelem::certify
