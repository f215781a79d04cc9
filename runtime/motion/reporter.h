#pragma once
#include "ir/diag/diagnostic.h"
#include "ir/diag/result.h"
#include "runtime/motion/records.h"
#include "runtime/motion/state.h"

namespace arelem::motion {

/// How a motion ended, as it is to be told: after one that failed the tool is not where the program
/// means it, and a motion that does not begin there is no fault of its own. The state remembers.
[[nodiscard]] std::optional<Failure> ofMotion(State& state, std::optional<Failure> failure);

/// Failures of Section 2: to the diagnostics, and as a record into the CL file, as in the old
/// system.
class Reporter {
 public:
  Reporter(RecordWriter& writer, DiagnosticSink& sink) : writer_(writer), sink_(sink) {}

  /// `action` is the statement at fault, `part` the part surface in force, if any.
  void report(const runtime::Action& action, Failure failure, const EntityPtr& part = nullptr);
  /// True after an error.
  [[nodiscard]] bool failed() const { return failed_; }
  /// True after an error that ends the run.
  [[nodiscard]] bool fatal() const { return fatal_; }

 private:
  RecordWriter& writer_;
  DiagnosticSink& sink_;
  bool failed_ = false;
  bool fatal_ = false;
};

}  // namespace arelem::motion
