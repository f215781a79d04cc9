#include "frontend/compile.h"

#include "frontend/check/program_reader.h"

namespace arelem::frontend {

ir::Program compile(SourceMap& sources,
                    BufferId buffer,
                    const Options& options,
                    DiagnosticSink& sink) {
  Reporter reporter(sink, options.limits);
  return ProgramReader(sources, options, reporter).run(buffer);
}

}  // namespace arelem::frontend
