#include "frontend/check/reporter.h"

#include "ir/diag/limits.h"

namespace arelem::frontend {

void Reporter::report(Diagnostic diagnostic) {
  const bool error = diagnostic.severity() == Severity::error;
  if (error && errors_ >= limits_.errors) {
    ++errors_;
    return;
  }
  if (said_.size() > 4 * limits_.errors) {
    return;  // warnings without end
  }
  if (!said_.emplace(diagnostic.row, diagnostic.at, diagnostic.message).second) {
    return;
  }
  errors_ += error ? 1 : 0;
  diagnostic.calledFrom.assign(calls_.rbegin(), calls_.rend());
  sink_.accept(std::move(diagnostic));
}

void Reporter::limit(Span at, std::string_view name, std::uint64_t value, std::string_view what) {
  report(diagnose(at, diag::LimitReached, what, value, name));
}

void Reporter::finish(Span end) {
  if (errors_ > limits_.errors) {
    sink_.accept(diagnose(end, diag::MoreErrors, errors_ - limits_.errors));
  }
}

}  // namespace arelem::frontend
