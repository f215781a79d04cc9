#pragma once
#include <set>
#include <string_view>
#include <tuple>
#include <vector>

#include "ir/diag/diagnostic.h"
#include "ir/limits.h"
#include "ir/program/feature.h"

namespace arelem::frontend {

/// Between the rooms of the frontend and the sink: adds the CALL chain, drops what was said already
/// at the same place (a macro body is checked once for every instance), and counts beyond the limit
/// of errors.
class Reporter {
 public:
  Reporter(DiagnosticSink& sink, const Limits& limits) : sink_(sink), limits_(limits) {}

  void report(Diagnostic diagnostic);
  /// The limit of flag `--max-NAME` was reached.
  void limit(Span at, std::string_view name, std::uint64_t value, std::string_view what);
  /// Ends the report: tells how many errors were counted but not shown.
  void finish(Span end);

  /// The text uses something that the program does not show.
  void used(ir::Feature feature) { features_.add(feature); }
  [[nodiscard]] const ir::FeatureCounts& features() const { return features_; }

  void enterCall(Span call) { calls_.push_back(call); }
  void leaveCall() { calls_.pop_back(); }
  [[nodiscard]] std::size_t callDepth() const { return calls_.size(); }
  [[nodiscard]] std::uint64_t errors() const { return errors_; }

 private:
  DiagnosticSink& sink_;
  const Limits& limits_;
  ir::FeatureCounts features_;
  std::vector<Span> calls_;
  std::set<std::tuple<const DiagRow*, Span, std::string>> said_;
  std::uint64_t errors_ = 0;
};

/// Swallows everything: for the first look over a program, whose findings the second one reports.
class SilentSink : public DiagnosticSink {
 public:
  void accept(Diagnostic /*diagnostic*/) override {}
};

}  // namespace arelem::frontend
