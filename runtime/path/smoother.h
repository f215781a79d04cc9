#pragma once
#include <memory>
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"

namespace arelem::path {

/// What SMOOTH did to one sequence of cut vectors.
struct SmoothFact {
  Span origin;                               ///< the statement of its first cut vector
  double mostBefore = 0.0, mostAfter = 0.0;  ///< curvature, per part unit
  double meanBefore = 0.0, meanAfter = 0.0;
  double lengthBefore = 0.0, lengthAfter = 0.0;
  double deviation = 0.0;  ///< bound, from the cut vectors
  /// Of the cut vectors given and put out, from rest to rest, at the feed in force; at the largest
  /// speed of the machine where there is none.
  double secondsBefore = 0.0, secondsAfter = 0.0;
};

/// Between SMOOTH/tol and SMOOTH/NOMORE, sequences of cut vectors become curves of less curvature,
/// put out as cut vectors again. A sequence ends at
/// a rapid move and at every record that is no motion. Of the tolerance, a share goes to the
/// fit of the curve to the cut vectors, the same share to its chords, and the rest to smoothing:
/// the new path is within the tolerance of the old one.
class Smoother : public cl::RecordSink {
 public:
  /// After the last record.
  virtual void finish() = 0;
  [[nodiscard]] virtual const std::vector<SmoothFact>& facts() const = 0;
};
[[nodiscard]] std::unique_ptr<Smoother> makeSmoother(cl::RecordSink& next,
                                                     DiagnosticSink& sink,
                                                     const InterruptFlag* interrupted = nullptr);

}  // namespace arelem::path
