#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/settings.h"
#include <CLI/CLI.hpp>

namespace arelem::app {

/// The options of every command that reads part programs.
void addSourceOptions(CLI::App& app, Settings& settings);
/// --diagnostics, --color, --max-errors, -q, -v.
void addMessageOptions(CLI::App& app, Settings& settings);

/// A number above 0, told in a few digits where it is not.
[[nodiscard]] CLI::Validator aboveZero();

/// Parses the words after the command. Help goes to standard output, wrong use to standard error.
/// Returns nothing when the command should run, else the exit code to end with.
[[nodiscard]] std::optional<int> parse(CLI::App& app, std::vector<std::string> words);

}  // namespace arelem::app
