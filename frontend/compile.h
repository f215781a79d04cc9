#pragma once
#include <map>
#include <string>
#include <vector>

#include "frontend/dialect.h"
#include "ir/diag/diagnostic.h"
#include "ir/limits.h"
#include "ir/program/program.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

struct Options {
  Dialect dialect = Dialect::automatic;
  /// Whether this dialect takes (with or without a warning) what a row of dialects.def names.
  [[nodiscard]] bool takes(Leave DialectRules::*rule) const {
    return rulesOf(dialect).*rule != Leave::refused;
  }
  /// Whether it takes it with a warning.
  [[nodiscard]] bool warns(Leave DialectRules::*rule) const {
    return rulesOf(dialect).*rule == Leave::warned;
  }
  Limits limits;
  std::map<std::string, double> defines;  ///< --define NAME=VALUE
  std::vector<std::string> libraryPath;   ///< where LIBRY and INCLUDE look
  const InterruptFlag* interrupted = nullptr;
};

/// Text to a checked program. Never throws on bad input; every error goes to the sink and the rest
/// is still read. LIBRY and INCLUDE add buffers to `sources`.
[[nodiscard]] ir::Program compile(SourceMap& sources,
                                  BufferId buffer,
                                  const Options& options,
                                  DiagnosticSink& sink);

}  // namespace arelem::frontend
