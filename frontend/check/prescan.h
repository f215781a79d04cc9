#pragma once
#include "frontend/check/names.h"
#include "frontend/lex/vocabulary.h"
#include "ir/text/source_map.h"

namespace arelem::frontend {

/// First look over a program: which names it assigns, and what each first assignment makes of them.
/// A program without `=`, RESERV and OBTAIN (a CL file) costs one search for `=`.
/// Names already known keep their class. Extension words that the program assigns yield.
void prescan(const SourceMap& sources,
             BufferId buffer,
             const Options& options,
             Vocabulary& vocabulary,
             Names& names);

}  // namespace arelem::frontend
