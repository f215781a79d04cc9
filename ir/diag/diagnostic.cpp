#include "ir/diag/diagnostic.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace arelem {

namespace {
constexpr auto table = std::to_array<DiagRow>({
#define ARELEM_DIAG(name, code, severity, legacy, text, ...) \
  DiagRow{#name, Severity::severity, code, legacy, text},
#include "ir/diag/diagnostics.def"
#undef ARELEM_DIAG
});

bool sameIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::toupper(x) == std::toupper(y);
  });
}
}  // namespace

std::span<const DiagRow> diagnosticTable() {
  return table;
}

const DiagRow* findDiagnostic(std::string_view codeOrName) {
  for (const DiagRow& row : table) {
    if (sameIgnoringCase(row.code, codeOrName) || sameIgnoringCase(row.name, codeOrName)) {
      return &row;
    }
  }
  return nullptr;
}

Diagnostic at(Span span, Failure failure) {
  Diagnostic d;
  d.row = failure.row;
  d.at = span;
  d.message = std::move(failure.message);
  d.notes = std::move(failure.notes);
  d.help = std::move(failure.help);
  return d;
}

void CollectingSink::accept(Diagnostic diagnostic) {
  if (diagnostic.severity() == Severity::error) {
    ++errors_;
  }
  all_.push_back(std::move(diagnostic));
}

void CollectingSink::clear() {
  all_.clear();
  errors_ = 0;
}

}  // namespace arelem
