#pragma once
#include <CLI/CLI.hpp>

#include "ir/limits.h"

namespace arelem::app {

/// One flag for each bound of `Limits`, `--max-steps N` and so on, in a help group of their own.
void addLimitOptions(CLI::App& app, Limits& limits);

}  // namespace arelem::app
