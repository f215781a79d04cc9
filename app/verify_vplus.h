#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "app/messages.h"
#include "app/rewritten.h"
#include "app/verify_path.h"

#include "backend/robot/machine.h"

namespace arelem::app {

/// Compares a V+ program with the path of its part program: poses, speeds, waits and outputs of
/// every location, the moves of every hole, and frame, TOOL and BASE with the machine file; then
/// what it does, instruction by instruction, with the program that compile writes: kinds of motion,
/// settings, outputs, stops, its end. The lines of pathS.c and pathB.c are compared as text. How
/// many locations agree; none after an error, which goes to the log.
[[nodiscard]] std::optional<std::size_t> verifyVplus(std::string_view text,
                                                     const std::string& name,
                                                     const robot::Machine& machine,
                                                     const Path& wanted,
                                                     const Rewritten& rewritten,
                                                     const Allowed& given,
                                                     DiagnosticLog& log);

}  // namespace arelem::app
