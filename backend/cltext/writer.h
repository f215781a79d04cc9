#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to cl`: ASCII CL as the postprocessors of CAM systems read it. One statement a line, `WORD /
/// a, b`, at most 72 columns, `$` continues; only the texts of PARTNO, PPRINT and INSERT may be
/// longer. Lengths are in the shortest fixed notation that reads back to the same double. What a
/// reader must not execute again (a TRACUT or COPY that is already applied), and what CL text has
/// no statement for, stands in `$$->` comments.
[[nodiscard]] std::unique_ptr<Writer> makeTextWriter(std::ostream& out,
                                                     const Context& context,
                                                     DiagnosticSink& sink);

}  // namespace arelem::backend
