#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to deck`: the lines of PUNCH and PRINT/4, each list closed by ENDPCH. They read back to the
/// same doubles where they stand behind READ/1. Needs no records.
[[nodiscard]] std::unique_ptr<Writer> makeDeckWriter(std::ostream& out,
                                                     const Context& context,
                                                     DiagnosticSink& sink);

}  // namespace arelem::backend
