#pragma once
#include <set>
#include <string>

#include "frontend/check/names.h"
#include "frontend/check/reporter.h"
#include "frontend/compile.h"
#include "frontend/lex/vocabulary.h"

namespace arelem::frontend {

/// What all checkers of one compilation share.
struct Context {
  Context(SourceMap& sources_, const Options& options_, Reporter& reporter_)
      : sources(sources_), options(options_), reporter(reporter_), vocabulary(options_.dialect) {}

  SourceMap& sources;
  const Options& options;
  Reporter& reporter;
  Vocabulary vocabulary;
  Names names;
  ir::Program program;
  /// In loops, macros and DO blocks a name may be used above its definition; the interpreter
  /// checks.
  bool lenient = false;

  /// Words that the program has as names or labels, which was told (E0212, E0213): what follows
  /// from that where they are used is no fault of its own.
  std::set<std::string, std::less<>> misnamed;

  void report(Diagnostic diagnostic);
};

}  // namespace arelem::frontend
