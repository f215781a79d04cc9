#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to cltape`: the binary CL tape, little-endian on every host. Records of at most 240 numbers;
/// a MULTAX record is supplied where points with an axis follow points without, or the other way
/// round.
[[nodiscard]] std::unique_ptr<Writer> makeTapeWriter(std::ostream& out,
                                                     const Context& context,
                                                     DiagnosticSink& sink);

}  // namespace arelem::backend
