#pragma once
#include <memory>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::path {

/// Section 3: applies TRACUT and COPY/INDEX to the records that pass and hands them on.
/// `finish()` after the last record releases what COPY still holds back.
class Transformer : public cl::RecordSink {
 public:
  virtual void finish() = 0;
};
[[nodiscard]] std::unique_ptr<Transformer> makeTransformer(cl::RecordSink& next, DiagnosticSink& sink);

}  // namespace arelem::path
