#include "app/output_plan.h"

#include <filesystem>
#include <map>
#include <system_error>

#include "app/nearest.h"
#include <fmt/format.h>
#include <unistd.h>

namespace arelem::app {

namespace {
namespace fs = std::filesystem;
using Refusal = std::optional<PlanRefusal>;

PlanRefusal unknownFormat(const std::string& name) {
  std::vector<std::string> known;
  for (const backend::Target& target : backend::targets()) {
    known.emplace_back(target.name);
  }
  const std::string guess = nearest(name, known);
  return {ExitCode::wrongUse, "there is no output format `" + name + "`" +
                                  (guess.empty() ? "; `arelem targets` lists them"
                                                 : "; did you mean `" + guess + "`?")};
}

/// Formats of another command.
bool isViewed(const std::string& file) {
  return file.ends_with(".png") || file.ends_with(".html");
}

/// The formats of --to; CL text when there is none.
Refusal findFormats(const std::vector<std::string>& names,
                    std::vector<const backend::Target*>& formats) {
  for (const std::string& name : names) {
    const backend::Target* target = backend::findTarget(name);
    if (target == nullptr) {
      return unknownFormat(name);
    }
    formats.push_back(target);
  }
  return std::nullopt;
}

const backend::Target* defaultFormat() {
  return backend::findTarget("cl");
}

Refusal planFiles(const OutputChoice& choice,
                  const std::vector<const backend::Target*>& formats,
                  PlannedJob& job) {
  if (formats.size() > 1) {
    return PlanRefusal{ExitCode::wrongUse, "several --to need --out-dir"};
  }
  for (const std::string& file : choice.files) {
    const backend::Target* target = !formats.empty() ? formats.front()
                                    : file == "-"    ? defaultFormat()
                                                     : backend::targetForFile(file);
    if (target == nullptr) {
      const std::string seen = "the suffix of `" + file + "` names no output format; ";
      return PlanRefusal{ExitCode::wrongUse, seen + (isViewed(file) ? "`arelem view` writes it"
                                                                    : "give one with --to")};
    }
    job.outputs.push_back({file, target});
  }
  return std::nullopt;
}

void planFolder(const std::string& folder,
                const std::vector<const backend::Target*>& formats,
                PlannedJob& job) {
  const std::string name = job.input == "-" ? "stdin" : fs::path(job.input).stem().string();
  for (const backend::Target* target : formats) {
    job.outputs.push_back(
        {(fs::path(folder) / (name + std::string(target->suffixes.front()))).string(), target});
  }
}

/// The outputs of one input: of a folder, of -o, or standard output.
Refusal planJob(const OutputChoice& choice,
                const std::vector<const backend::Target*>& formats,
                PlannedJob& job) {
  if (!choice.folder.empty()) {
    planFolder(choice.folder, formats.empty() ? std::vector{defaultFormat()} : formats, job);
    return std::nullopt;
  }
  if (!choice.files.empty()) {
    return planFiles(choice, formats, job);
  }
  if (formats.size() > 1) {
    return PlanRefusal{ExitCode::wrongUse, "several --to need --out-dir"};
  }
  job.outputs.push_back({"-", formats.empty() ? defaultFormat() : formats.front()});
  return std::nullopt;
}

/// One spelling for every way to write the same place.
std::string canonical(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path), error);
  return error ? path : whole.string();
}

Refusal objectionTo(const PlannedOutput& output, const OutputChoice& choice) {
  if (output.path == "-") {
    const bool refused = output.target->binary && !choice.force && ::isatty(STDOUT_FILENO) == 1;
    return refused ? Refusal({ExitCode::wrongUse,
                              fmt::format("`{}` is binary and standard output is a terminal; "
                                          "use -o FILE, or --force",
                                          output.target->name)})
                   : std::nullopt;
  }
  std::error_code error;
  if (fs::is_directory(output.path, error)) {
    return PlanRefusal{ExitCode::outputNotWritten, "the output `" + output.path + "` is a folder"};
  }
  const fs::path parent = fs::path(output.path).parent_path();
  if (choice.folder.empty() && !parent.empty() && !fs::is_directory(parent, error)) {
    return PlanRefusal{ExitCode::outputNotWritten,
                       "there is no folder `" + parent.string() + "` for the output"};
  }
  return std::nullopt;
}

/// Collisions of outputs with inputs and with each other, over all jobs of the command.
Refusal objectionTo(const std::vector<PlannedJob>& jobs, const OutputChoice& choice) {
  std::map<std::string, std::string> taken;  // canonical path -> "is an input"
  for (const PlannedJob& job : jobs) {
    if (job.input != "-") {
      taken.emplace(canonical(job.input), "is an input");
    }
  }
  for (const PlannedJob& job : jobs) {
    std::vector<PlannedOutput> all = job.outputs;
    if (!job.report.empty()) {
      all.push_back({job.report, backend::findTarget("json")});
    }
    for (const PlannedOutput& output : all) {
      if (Refusal refusal = objectionTo(output, choice)) {
        return refusal;
      }
      std::error_code error;
      const bool device =
          fs::exists(output.path, error) && !fs::is_regular_file(output.path, error);
      const auto [entry, isNew] =
          taken.emplace(output.path == "-" ? "-" : canonical(output.path), "is given twice");
      if (!isNew && !device) {
        return PlanRefusal{ExitCode::wrongUse, "the output `" + output.path + "` " + entry->second};
      }
    }
  }
  return std::nullopt;
}
}  // namespace

Refusal planOutputs(const std::vector<std::string>& inputs,
                    const OutputChoice& choice,
                    std::vector<PlannedJob>& jobs) {
  std::vector<const backend::Target*> formats;
  if (Refusal refusal = findFormats(choice.formats, formats)) {
    return refusal;
  }
  if (!choice.files.empty() && !choice.folder.empty()) {
    return PlanRefusal{ExitCode::wrongUse, "-o and --out-dir exclude each other"};
  }
  if (inputs.size() > 1 && choice.folder.empty()) {
    return PlanRefusal{ExitCode::wrongUse, "several inputs need --out-dir"};
  }
  if (inputs.size() > 1 && !choice.report.empty()) {
    return PlanRefusal{ExitCode::wrongUse, "--report takes one input"};
  }
  for (const std::string& input : inputs) {
    PlannedJob job{input, {}, choice.report};
    if (Refusal refusal = planJob(choice, formats, job)) {
      return refusal;
    }
    jobs.push_back(std::move(job));
  }
  return objectionTo(jobs, choice);
}

}  // namespace arelem::app
