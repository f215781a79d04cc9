#pragma once
#include <optional>
#include <string>

#include "app/repl/session.h"

namespace arelem::app::repl {

/// What may stand at the end of a line that is a command, or ends within a quoted file name;
/// nothing of another one.
[[nodiscard]] std::optional<frontend::Completion> completeCommandOrFile(const Session& session,
                                                                        const std::string& line);

}  // namespace arelem::app::repl
