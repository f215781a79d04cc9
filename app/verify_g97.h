#pragma once
#include <string_view>

#include "app/rewritten.h"
#include "app/verify_path.h"

#include "backend/robot/machine.h"

namespace arelem::app {

/// Reads G97 programs to the letter and compares poses, kinds of moves, speeds and outputs with the
/// program's, but for what their digits take away. Blocks that only carry one more code at their
/// place, or begin a program where the one before ended, are no locations. Then block by block with
/// what compile writes: numbers of programs, P, Q and R, every code. The first difference is told.
/// Returns the number of locations, or none after an error.
[[nodiscard]] std::optional<std::size_t> verifyG97(std::string_view text,
                                                   const std::string& name,
                                                   const robot::Machine& machine,
                                                   const Path& wanted,
                                                   const Rewritten& rewritten,
                                                   const Allowed& given,
                                                   DiagnosticLog& log);

}  // namespace arelem::app
