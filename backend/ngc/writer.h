#pragma once
#include "backend/backend.h"

namespace arelem::backend {

/// RS-274/NGC, as the interpreter of LinuxCNC reads it. Complete or refused: what the control file
/// does not allow is an error. See docs/manual/targets.md.
[[nodiscard]] std::unique_ptr<Writer> makeNgcWriter(std::ostream& out,
                                                    const Context& context,
                                                    DiagnosticSink& sink);

}  // namespace arelem::backend
