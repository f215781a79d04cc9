#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/exit_code.h"

#include "backend/backend.h"

namespace arelem::app {

/// What the command line says about outputs.
struct OutputChoice {
  std::vector<std::string> files;    ///< -o, in order; - is standard output
  std::vector<std::string> formats;  ///< --to
  std::string folder;                ///< --out-dir, "" when not given
  std::string report;                ///< --report, "" when not given
  bool force = false;                ///< binary to a terminal
};

struct PlannedOutput {
  std::string path;  ///< - is standard output
  const backend::Target* target = nullptr;
};

/// One input with everything that is to be made from it.
struct PlannedJob {
  std::string input;
  std::vector<PlannedOutput> outputs;
  std::string report;  ///< "" when none is wanted
};

/// Why the command cannot be carried out as given.
struct PlanRefusal {
  ExitCode code = ExitCode::wrongUse;
  std::string text;
};

/// Decides which file is made from which input in which format, before any work:
///  * the format follows from --to, else from the suffix of -o, else it is CL text;
///  * --out-dir DIR makes DIR/<name of the input><suffix> for each --to;
///  * without -o and --out-dir the result goes to standard output, which takes one input only.
/// Refuses outputs that are an input, appear twice, are folders or lie in no folder, and binary
/// formats that would go to a terminal.
[[nodiscard]] std::optional<PlanRefusal> planOutputs(const std::vector<std::string>& inputs,
                                                     const OutputChoice& choice,
                                                     std::vector<PlannedJob>& jobs);

}  // namespace arelem::app
