#include "app/rewritten.h"

#include <algorithm>
#include <iterator>

namespace arelem::app {

Rewritten::Rewritten(const backend::Target* target, std::optional<robot::Machine> machine)
    : machine_(std::move(machine)) {
  if (target != nullptr) {
    backend::Context context;
    context.machine = machine_ ? &*machine_ : nullptr;
    writer_ = target->make(out_, context, told_);
  }
}

void Rewritten::accept(const cl::Record& record) {
  path_.accept(record);
  if (writer_) {
    writer_->accept(record);
  }
}

void Rewritten::finish() {
  if (writer_) {
    writer_->finish();
  }
}

std::vector<Diagnostic> Rewritten::errors() const {
  std::vector<Diagnostic> errors;
  std::copy_if(told_.all().begin(), told_.all().end(), std::back_inserter(errors),
               [](const Diagnostic& told) { return told.severity() >= Severity::error; });
  return errors;
}

bool isWritten(const Rewritten& rewritten, DiagnosticLog& log) {
  const std::vector<Diagnostic> errors = rewritten.errors();
  for (const Diagnostic& error : errors) {
    log.accept(error);
  }
  return errors.empty();
}

}  // namespace arelem::app
