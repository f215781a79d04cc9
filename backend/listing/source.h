#pragma once
#include <iosfwd>

#include "ir/program/program.h"
#include "ir/text/source_map.h"

namespace arelem::backend {

/// Prints every source text that holds statements, line by line, with the statement number (ISN)
/// before the line where the statement begins.
void printSource(std::ostream& out, const SourceMap& sources, const ir::Program& program);

}  // namespace arelem::backend
