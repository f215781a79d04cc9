#pragma once
#include "backend/backend.h"

namespace arelem::backend {

/// Programs of Fanuc R-G2 controllers. L inside passes, P after RAPID; RON and ROF in the block
/// whose target is reached when the gun is switched. `context.machine` gives frame, tool, outputs,
/// traverse speed, envelope and the literals of the controller. More blocks than one program takes
/// are divided where the gun is off.
[[nodiscard]] std::unique_ptr<Writer> makeG97Writer(std::ostream& out,
                                                    const Context& context,
                                                    DiagnosticSink& sink);

}  // namespace arelem::backend
