#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to ir`: the stable text of the checked program (ir::print). Needs no records.
[[nodiscard]] std::unique_ptr<Writer> makeProgramWriter(std::ostream& out,
                                                        const Context& context,
                                                        DiagnosticSink& sink);

}  // namespace arelem::backend
