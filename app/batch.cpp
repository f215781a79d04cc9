#include "app/batch.h"

#include <filesystem>
#include <iostream>
#include <thread>

#include "app/messages.h"
#include "app/output_file.h"
#include "app/sha256.h"
#include "app/source_file.h"
#include "app/progress_bar.h"
#include "app/worker.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ir/diag/render_text.h"

namespace arelem::app {

namespace {
/// The table of a larger batch shows only what went wrong.
constexpr std::size_t wholeTable = 50;

std::string_view resultName(ExitCode code) {
  switch (code) {
    case ExitCode::ok:
      return "done";
    case ExitCode::programHasErrors:
      return "errors";
    case ExitCode::inputUnreadable:
      return "unreadable";
    case ExitCode::geometryUnsolvable:
      return "unsolvable";
    case ExitCode::verificationFailed:
      return "not verified";
    case ExitCode::outputNotWritten:
      return "not written";
    case ExitCode::limitReached:
      return "limit";
    case ExitCode::interrupted:
    case ExitCode::terminated:
      return "interrupted";
    default:
      return "crashed";
  }
}

void printTable(const std::vector<JobResult>& results) {
  std::size_t width = 4;
  std::size_t done = 0;
  for (const JobResult& result : results) {
    width = std::max(width, result.input.size());
    done += result.code == ExitCode::ok ? 1 : 0;
  }
  std::cerr << fmt::format("{:<{}}  {:<12} {:>6} {:>8} {:>11} {:>9}\n", "job", width, "result",
                           "errors", "warnings", "cut vectors", "seconds");
  for (const JobResult& result : results) {
    if (results.size() <= wholeTable || result.code != ExitCode::ok) {
      std::cerr << fmt::format("{:<{}}  {:<12} {:>6} {:>8} {:>11} {:>9.2f}\n", result.input, width,
                               resultName(result.code), result.errors, result.warnings,
                               result.cutVectors, result.seconds);
    }
  }
  std::cerr << fmt::format("{}: {} done, {} failed\n", counted(results.size(), "job"), done,
                           results.size() - done);
}

/// Path, size and hash of a file; only its path where there is none.
nlohmann::ordered_json described(const std::string& path, const Limits& limits) {
  nlohmann::ordered_json file = {{"path", path}};
  if (Result<std::string> bytes = readBytes(path, limits)) {
    file["bytes"] = (*bytes).size();
    file["sha256"] = sha256(*bytes);
  }
  return file;
}

std::string manifestText(const std::vector<PlannedJob>& plans,
                         const std::vector<JobResult>& results,
                         const Limits& limits) {
  nlohmann::ordered_json all = {{"jobs", nlohmann::ordered_json::array()}};
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const JobResult& result = results[i];
    nlohmann::ordered_json job = {{"input", described(plans[i].input, limits)},
                                  {"exitCode", static_cast<int>(result.code)},
                                  {"errors", result.errors},
                                  {"warnings", result.warnings},
                                  {"cutVectors", result.cutVectors},
                                  {"outputs", nlohmann::ordered_json::array()}};
    for (const PlannedOutput& output : plans[i].outputs) {
      if (result.code == ExitCode::ok) {
        job["outputs"].push_back(described(output.path, limits));
      }
    }
    all["jobs"].push_back(std::move(job));
  }
  return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

ExitCode writeManifest(const std::string& path, const std::string& text) {
  Result<std::unique_ptr<OutputFile>> file = openOutput(path);
  if (file) {
    (*file)->stream() << text;
    Result<std::uint64_t> bytes = (*file)->complete();
    Result<std::string> name =
        bytes ? (*file)->commit(false) : Result<std::string>(bytes.takeFailure());
    if (name) {
      return ExitCode::ok;
    }
  }
  printError("cannot write the manifest `" + path + "`");
  return ExitCode::outputNotWritten;
}
}  // namespace

ExitCode runBatch(const std::vector<PlannedJob>& plans,
                  const std::vector<std::string>& options,
                  const BatchChoice& choice,
                  const std::string& folder,
                  const Settings& settings,
                  const InterruptFlag& interrupted) {
  std::vector<std::string> inputs;
  for (const PlannedJob& plan : plans) {
    inputs.push_back(plan.input);
  }
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t asked = choice.jobs.value_or(1);
  const auto progress = progressOnTerminal();
  ExitCode code = ExitCode::ok;
  const auto results = runWorkers(inputs, options, asked == 0 ? processors : asked, interrupted,
                                  [&](std::size_t index, const JobResult& result) {
                                    if (progress && !result.messages.empty()) {
                                      std::cerr << "\r\x1b[K";
                                    }
                                    std::cerr << result.messages;
                                    code = worse(code, result.code);
                                    if (progress) {
                                      progress("jobs", index + 1, inputs.size());
                                    }
                                  });
  if (!settings.quiet) {
    printTable(results);
  }
  const std::string manifest = !choice.manifest.empty() ? choice.manifest
                               : folder.empty()
                                   ? ""
                                   : (std::filesystem::path(folder) / "manifest.json").string();
  if (!manifest.empty() && !interrupted) {
    code = worse(code, writeManifest(manifest, manifestText(plans, results, settings.limits)));
  }
  return code;
}

}  // namespace arelem::app
