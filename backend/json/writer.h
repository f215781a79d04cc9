#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to json`: one JSON object a line for each record. `rec` counts as on a CLTAPE; the 1000
/// records count and are folded into `isn`. See docs/manual/targets.md for the fields.
[[nodiscard]] std::unique_ptr<Writer> makeJsonWriter(std::ostream& out,
                                                     const Context& context,
                                                     DiagnosticSink& sink);

}  // namespace arelem::backend
