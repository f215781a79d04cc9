#pragma once
#include <string>

#include "app/settings.h"

#include "backend/robot/machine.h"

namespace arelem::app {

/// A machine file by its path, or by its name in the folders of the library.
[[nodiscard]] Result<robot::Machine> loadMachine(const std::string& name, const Settings& settings);

}  // namespace arelem::app
