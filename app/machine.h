#pragma once
#include <optional>
#include <string>

#include "app/settings.h"
#include <CLI/CLI.hpp>

#include "backend/robot/machine.h"
#include "runtime/timing/cut_timer.h"

namespace arelem::app {

/// What the command line says of the robot.
struct MachineChoice {
  std::string file;    ///< of --machine, "" when not given
  std::string compat;  ///< of --compat, "" when not given
};
void addMachineOptions(CLI::App& app, MachineChoice& choice);

/// The machine file by its path, or by its name in the folders of the library, with what --compat
/// changes; none where neither is given.
[[nodiscard]] Result<std::optional<robot::Machine>> loadMachine(const MachineChoice& choice,
                                                                const Settings& settings);

/// The limits of a machine file for the time law, or the usual ones without a file.
[[nodiscard]] timing::Machine timingMachine(const robot::Machine* machine);

}  // namespace arelem::app
