#pragma once
#include "backend/backend.h"

namespace arelem::backend {

/// Programs of the Fanuc R-G2 controller with G97 positions (Sen 4.2). What Sen does not show is
/// not written: words without a form are told and left out. Errors: E0660 to E0664.
[[nodiscard]] std::unique_ptr<Writer> makeG97Writer(std::ostream& out,
                                                    const Context& context,
                                                    DiagnosticSink& sink);

}  // namespace arelem::backend
