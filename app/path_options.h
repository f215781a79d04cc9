#pragma once
#include <CLI/CLI.hpp>

namespace arelem::app {

/// --fit: the share of the tolerance that arcs and lines may use (runtime/path/arc_fit.h).
void addFitOption(CLI::App& app, double& share);

}  // namespace arelem::app
