#pragma once
#include <functional>
#include <ostream>
#include <string>

#include "app/messages.h"

namespace arelem::app {

/// One picture, page or table at `path`, complete or not at all; `write` is given the stream and
/// tells whether it could. Faults go to the log.
void putPicture(DiagnosticLog& log,
                const std::string& path,
                const std::function<bool(std::ostream&)>& write);

}  // namespace arelem::app
