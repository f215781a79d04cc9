#pragma once
#include <vector>

#include "ir/diag/diagnostic.h"

namespace arelem {

/// The order in which people should read the diagnostics of one run: by place, causes before
/// consequences.
///  * What happened inside a macro stands at the CALL of the main program that led there.
///  * Included texts come before the text that includes them (`mainBuffer`), as they define what it
///  uses.
///  * Equal places keep the order in which they were reported.
/// The same message at the same place (from a loop) is kept once, with a note of how often it came.
[[nodiscard]] std::vector<Diagnostic> inReadingOrder(std::vector<Diagnostic> diagnostics,
                                                     BufferId mainBuffer);

}  // namespace arelem
