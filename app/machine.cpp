#include "app/machine.h"

#include <filesystem>

#include "app/library_path.h"
#include "app/source_file.h"

#include "ir/text/find_file.h"

namespace arelem::app {

namespace {
Result<robot::Machine> readFile(const std::string& name, const Settings& settings) {
  std::vector<std::string> folders = settings.libraryPath;
  for (std::string& folder : installedLibrary()) {
    folders.push_back(std::move(folder));
  }
  std::error_code error;
  const Found found = std::filesystem::exists(name, error) ? Found{} : findInside(name, folders);
  const std::string path = found.state == Found::State::inside ? found.path.string() : name;
  Result<std::string> text = readBytes(path, settings.limits);
  if (!text) {
    return text.takeFailure();
  }
  return robot::readMachine(*text, displayName(path));
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
