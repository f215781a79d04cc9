#include "frontend/compile.h"

#include "frontend/check/program_reader.h"

namespace arelem::frontend {

ir::Program compile(SourceMap& sources,
                    BufferId buffer,
                    const Options& options,
                    DiagnosticSink& sink) {
  Options chosen = options;
  if (options.dialect == Dialect::automatic && looksLikeCl(sources.text(buffer))) {
    chosen.dialect = Dialect::cl;
  }
  Reporter reporter(sink, chosen.limits);
  return ProgramReader(sources, chosen, reporter).run(buffer);
}

}  // namespace arelem::frontend
