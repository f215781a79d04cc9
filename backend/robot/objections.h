#pragma once
#include <string>
#include <vector>

#include "ir/diag/diagnostic.h"

namespace arelem::robot {

/// Why a robot cannot take a pose, and by how much its limit is passed: mm or degrees.
struct Objection {
  Failure failure;
  double excess = 0.0;
};

/// Objections to the locations of a path. Each kind is told once: its worst, how many locations
/// there are of it, and the first few.
class Objections {
 public:
  /// Several objections of one kind to one location count once; locations come in their order.
  void add(Objection objection, std::size_t location, const Span& origin);
  [[nodiscard]] bool empty() const { return kinds_.empty(); }
  /// `locations` is how many the path has.
  void report(std::size_t locations, DiagnosticSink& sink) const;

 private:
  struct Kind {
    Objection worst;
    Span origin;
    std::size_t count = 0;
    std::vector<std::size_t> first;
    std::size_t last = 0;  ///< location
  };
  std::vector<Kind> kinds_;
};

}  // namespace arelem::robot
