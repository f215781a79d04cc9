#pragma once
#include "backend/backend.h"
#include "backend/robot/machine.h"

namespace arelem::backend {

/// The lines that the programs of Blank's appendix A print for the Adept: a move, then the speed of
/// the next one, to be read into a program of the controller. What is neither is left out, as
/// there.
[[nodiscard]] std::unique_ptr<Writer> makeBlankWriter(std::ostream& out,
                                                      const robot::Machine& machine,
                                                      DiagnosticSink& sink);

}  // namespace arelem::backend
