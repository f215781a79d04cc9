#pragma once
#include <iosfwd>
#include <string>
#include <string_view>

#include "ir/diag/diagnostic.h"
#include "ir/text/source_map.h"

namespace arelem {

/// One JSON object on one line:
///   {"severity","code","legacy","file","range","message","related","calledFrom","notes","help","fixes"}.
/// A position carries line and column (code points, from 1), byte offset in the file and utf16
/// (code units from the start of the line, from 0). Readers must tolerate new fields.
void renderJson(std::ostream& out, const Diagnostic& diagnostic, const SourceMap& sources);

/// `text` as a JSON string with its quotes; bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string jsonString(std::string_view text);

}  // namespace arelem
