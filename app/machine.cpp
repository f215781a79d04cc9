#include "app/machine.h"

#include "app/library_file.h"

namespace arelem::app {

namespace {
Result<robot::Machine> readFile(const std::string& name, const Settings& settings) {
  Result<LibraryFile> file = readLibraryFile(name, settings, "machines");
  if (!file) {
    return file.takeFailure();
  }
  return robot::readMachine(file->text, file->name);
}
}  // namespace

void addMachineOptions(CLI::App& app, MachineChoice& choice) {
  app.add_option(
         "--machine", choice.file,
         "the machine that the program is for: a TOML file, looked for here and in the library")
      ->type_name("FILE");
  app.add_option("--compat", choice.compat,
                 "angles of G97 by the formulas of the program that wrote such files")
      ->check(CLI::IsMember({"robopaint"}))
      ->type_name("NAME");
}

Result<std::optional<robot::Machine>> loadMachine(const MachineChoice& choice,
                                                  const Settings& settings) {
  std::optional<robot::Machine> machine;
  if (!choice.file.empty()) {
    Result<robot::Machine> read = readFile(choice.file, settings);
    if (!read) {
      return read.takeFailure();
    }
    machine = *std::move(read);
  }
  if (!choice.compat.empty()) {
    machine = machine.value_or(robot::Machine{});
    machine->g97.robopaint = true;
  }
  return machine;
}

timing::Machine timingMachine(const robot::Machine* machine) {
  const robot::TimeLimits limits =
      machine != nullptr ? machine->time.value_or(robot::TimeLimits{}) : robot::TimeLimits{};
  return {{limits.velocity, limits.acceleration, limits.jerk}, limits.corner, limits.toolChange};
}

}  // namespace arelem::app
