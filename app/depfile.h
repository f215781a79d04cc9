#pragma once
#include <string>

#include "app/output_plan.h"
#include "app/pipeline.h"

namespace arelem::app {

/// A rule of make and ninja: the outputs depend on the program and on every file that was read for
/// it (INCLUDE, LIBRY, data files, the machine).
void writeDepfile(Compilation& job,
                  const PlannedJob& plan,
                  const std::vector<std::string>& more,
                  const std::string& path);

}  // namespace arelem::app
