#pragma once
#include <ostream>

#include "app/pipeline.h"

namespace arelem::app {

/// How often each word begins a statement of the program, and what became of it (`check --words`):
///   understood   its meaning is known to the computation of the path or to the outputs
///   passed on    it stands in the CL data as it was written
///   reported     a diagnostic tells of it (an error, or that it has no effect)
/// Comments are counted in a line of their own. `diagnostics` are those of the job, before they are
/// printed.
void printWordCounts(std::ostream& out, const Compilation& job);

}  // namespace arelem::app
