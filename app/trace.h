#pragma once
#include <ostream>

#include "app/pipeline.h"

namespace arelem::app {

/// What DEBUG asks for, a line a statement: of Section 1 names with their values, jumps and calls
/// in order of execution; of Section 2 each motion with its cut vectors, length, end, axis and what
/// the ends of its cut vectors leave the surfaces by.
void printTrace(std::ostream& out, const Compilation& job);

}  // namespace arelem::app
