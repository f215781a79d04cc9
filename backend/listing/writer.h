#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to listing`: the program with its statement numbers, what PRINT and TITLES asked for, and the
/// records as CLPRNT shows them. A part that the context does not have is left out.
[[nodiscard]] std::unique_ptr<Writer> makeListingWriter(std::ostream& out,
                                                        const Context& context,
                                                        DiagnosticSink& sink);

}  // namespace arelem::backend
