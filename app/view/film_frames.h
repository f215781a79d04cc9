#pragma once
#include "app/pipeline.h"

#include "runtime/path/affine.h"

namespace arelem::app {

/// Where TRACUT puts what statements paint: films are computed in the system of the part, and shown
/// where the path paints them. Statements are asked for in the order of their execution.
class FilmFrames {
 public:
  explicit FilmFrames(const Compilation& job) : actions_(job.evaluation.actions) {}

  /// The matrix of TRACUT at the next execution of the statement at `origin`.
  [[nodiscard]] path::Affine next(const Span& origin);

 private:
  void pass(const runtime::Action& action);

  const std::vector<runtime::Action>& actions_;
  std::size_t at_ = 0;
  path::Affine tracut_;
};

}  // namespace arelem::app
