#pragma once
#include <string>
#include <vector>

#include "app/output_plan.h"
#include "app/settings.h"
#include <CLI/CLI.hpp>

namespace arelem::app {

/// What --jobs and --manifest ask for.
struct BatchChoice {
  std::optional<std::size_t> jobs;  ///< at once; 0: as many as there are processors
  std::string manifest;             ///< "" : manifest.json in the folder of the outputs
};

/// Compiles every planned job in a process of its own and tells of all: messages in the order of
/// the inputs, a progress bar on a terminal, a table, and a manifest with the SHA-256 of inputs and
/// outputs, which holds nothing that differs from run to run. A job that fails stops no other.
[[nodiscard]] ExitCode runBatch(const std::vector<PlannedJob>& plans,
                                const std::vector<std::string>& options,
                                const BatchChoice& choice,
                                const std::string& folder,
                                const Settings& settings,
                                const InterruptFlag& interrupted);

}  // namespace arelem::app
