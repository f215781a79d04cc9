#pragma once
#include <ostream>
#include <string>

#include "app/repl/display.h"

namespace arelem::app::repl {

/// How an entity was found: its statement, the form, the values that went in, and what the other
/// modifiers of the form would have given, with the reason why that is not the result. False when
/// the session has no entity of this name, or the evaluation was interrupted.
[[nodiscard]] bool printWhy(std::ostream& out,
                            const Session& session,
                            const Settings& settings,
                            const std::string& name,
                            int subscript,
                            const Style& style,
                            const InterruptFlag& interrupted);

}  // namespace arelem::app::repl
