#include "runtime/interpret/interpreter.h"
#include "runtime/run.h"

namespace arelem::runtime {

Evaluation evaluate(const ir::Program& program, const Options& options, DiagnosticSink& sink) {
  Evaluation result;
  interpret::Interpreter(program, options, sink, result).run();
  return result;
}

Evaluation evaluateInPieces(const ir::Program& program,
                            const Options& options,
                            DiagnosticSink& sink,
                            const PieceCall& piece) {
  Evaluation result;
  interpret::Interpreter interpreter(program, options, sink, result);
  interpreter.handOver(piece);
  interpreter.run();
  return result;
}

}  // namespace arelem::runtime
