#include "runtime/interpret/interpreter.h"
#include "runtime/run.h"

namespace arelem::runtime {

Evaluation evaluate(const ir::Program& program, const Options& options, DiagnosticSink& sink) {
  Evaluation result;
  interpret::Interpreter(program, options, sink, result).run();
  return result;
}

}  // namespace arelem::runtime
