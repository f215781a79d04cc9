#pragma once
#include "backend/backend.h"

namespace arelem::backend {

/// V+ programs for Adept and Staubli controllers, for milling, spraying and stencil records alike.
/// `context.machine` gives frame, limits, tilt axis and style; without it the coordinates of the
/// part program are those of the robot and nothing is checked.
[[nodiscard]] std::unique_ptr<Writer> makeVplusWriter(std::ostream& out,
                                                      const Context& context,
                                                      DiagnosticSink& sink);

}  // namespace arelem::backend
