#pragma once
#include <map>
#include <string>
#include <vector>

#include "ir/diag/diagnostic.h"
#include "ir/limits.h"
#include "ir/program/program.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

enum class Dialect : std::uint8_t {
  automatic,  ///< native, with what legacy programs need
  apt360,     ///< strict: six-character names, no extension words
  apt4,
  cl,  ///< CL text of CAM systems: free width, unknown words pass
  native
};

struct Options {
  Dialect dialect = Dialect::automatic;
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
