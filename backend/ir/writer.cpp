#include "backend/ir/writer.h"

#include <ostream>

#include "ir/diag/output.h"

namespace arelem::backend {

namespace {
class ProgramWriter : public Writer {
 public:
  ProgramWriter(std::ostream& out, const Context& context, DiagnosticSink& sink)
      : out_(out), context_(context), sink_(sink) {}

  void accept(const cl::Record&) override {}
  void finish() override {
    if (context_.program == nullptr) {
      sink_.accept(diagnose(Span{}, diag::NoProgram, "ir"));
      return;
    }
    ir::print(out_, *context_.program);
    out_.flush();
  }

 private:
  std::ostream& out_;
  const Context& context_;
  DiagnosticSink& sink_;
};
}  // namespace

std::unique_ptr<Writer> makeProgramWriter(std::ostream& out,
                                          const Context& context,
                                          DiagnosticSink& sink) {
  return std::make_unique<ProgramWriter>(out, context, sink);
}

}  // namespace arelem::backend
