#pragma once
#include <string>

#include "runtime/run.h"

namespace arelem::app {

/// "MINCST [########        ] 90/451, 12 s left", in less than `columns` columns: without the bar
/// where it would be too short to see, without the time where there is no room.
[[nodiscard]] std::string progressLine(
    std::string_view what, std::size_t done, std::size_t all, int columns, double secondsLeft);

/// A bar on standard error where that is a terminal with a cursor and the work takes more than a
/// second; else nothing.
[[nodiscard]] runtime::ProgressCall progressOnTerminal();

}  // namespace arelem::app
