#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include <CLI/CLI.hpp>

#include "ir/limits.h"

/// Jobs of a batch run as processes of their own: a job that crashes or runs out of memory takes
/// no other with it, and nothing is shared between them.
namespace arelem::app {

/// What one job of a batch did, in the order of the inputs.
struct JobResult {
  std::string input;
  ExitCode code = ExitCode::ok;
  int signal = 0;        ///< that ended the process; 0 when it ended by itself
  std::string messages;  ///< what it wrote to standard error
  std::uint64_t errors = 0, warnings = 0, cutVectors = 0;
  double seconds = 0.0;
};

/// The words of a command without its positional ones and without the options named in `without`.
/// `app` has parsed them and knows which options take a value.
[[nodiscard]] std::vector<std::string> optionsOnly(const CLI::App& app,
                                                   const std::vector<std::string>& words,
                                                   const std::vector<std::string>& without);

/// Told after every job that has ended.
using JobCall = std::function<void(std::size_t index, const JobResult& result)>;

/// Runs `arelem compile INPUT OPTIONS` for each input, at most `atOnce` at a time. `done` is called
/// in the order of the inputs. After an interrupt no job is started, and those at work are ended.
[[nodiscard]] std::vector<JobResult> runWorkers(const std::vector<std::string>& inputs,
                                                const std::vector<std::string>& options,
                                                std::size_t atOnce,
                                                const InterruptFlag& interrupted,
                                                const JobCall& done);

/// What a worker tells its batch on the file descriptor of the hidden option --tally; false when it
/// cannot.
bool writeTally(int descriptor,
                std::uint64_t errors,
                std::uint64_t warnings,
                std::uint64_t cutVectors);

}  // namespace arelem::app
