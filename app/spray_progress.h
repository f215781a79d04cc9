#pragma once
#include "runtime/run.h"

namespace arelem::app {

/// A bar on standard error where that is a terminal and the work takes more than a second; else
/// nothing.
[[nodiscard]] runtime::ProgressCall progressOnTerminal();

}  // namespace arelem::app
