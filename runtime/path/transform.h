#pragma once
#include <memory>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"

namespace arelem::path {

/// Section 3: applies TRACUT and COPY/INDEX to the records that pass and hands them on.
///
/// TRACUT/m moves every location by p' = m p and its tool axis by the rotation of m, until the next
/// TRACUT. INDEX/i opens a range of records, as TRACUT left them; INDEX/i,NOMORE or the first
/// COPY/i ends it. COPY/i repeats the range n times: before every copy stands INDEX/i, after the
/// last one the COPY itself, and the k-th copy is moved by the k-th power of the matrix. Ranges may
/// nest three deep, three COPY may share one. Only records inside a range are kept; everything else
/// passes at once.
class Transformer : public cl::RecordSink {
 public:
  /// After the last record: reports ranges without COPY.
  virtual void finish() = 0;
};
[[nodiscard]] std::unique_ptr<Transformer> makeTransformer(
    cl::RecordSink& next,
    DiagnosticSink& sink,
    const Limits& limits = {},
    const InterruptFlag* interrupted = nullptr);

}  // namespace arelem::path
