#include "ir/diag/interpret.h"
#include "runtime/interpret/interpreter.h"
#include "runtime/run.h"

namespace arelem::runtime {

Evaluation evaluate(const ir::Program& program, const Options& options, DiagnosticSink& sink) {
  Evaluation result;
  interpret::Interpreter(program, options, sink, result).run();
  return result;
}

void reportIgnored(const std::vector<Ignored>& ignored, DiagnosticSink& sink) {
  for (const Ignored& known : ignored) {
    sink.accept(diagnose(known.first, diag::NoEffect, known.what, known.why, known.times));
  }
}

}  // namespace arelem::runtime
