#pragma once
#include <iosfwd>

#include "backend/cltape/reader.h"

namespace arelem::backend {

/// Lists a CLTAPE readably, one line a record: number, byte offset, class/subclass, words, meaning.
/// Raw words of records that are not understood are shown in hexadecimal.
TapeSummary dump(std::istream& in,
                 std::ostream& out,
                 DiagnosticSink& sink,
                 const Limits& limits = {},
                 const tape::Codes& codes = {});

}  // namespace arelem::backend
