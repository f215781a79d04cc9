#include "backend/cltape/dump.h"

#include <iostream>
#include <sstream>

#include "app/cl_input.h"
#include "app/code_file.h"
#include "app/command.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/source_file.h"

namespace arelem::app {

namespace {
ExitCode dumpTape(const std::string& path, std::string bytes, const Settings& settings) {
  Compilation job(settings);
  job.main = job.sources.add(displayName(path), "");
  std::istringstream in(std::move(bytes));
  if (readCodes(job)) {
    backend::dump(in, std::cout, job.log, settings.limits, job.codes);
  }
  std::cout.flush();
  job.log.print(job.sources, job.main, settings);
  return job.log.exitCode();
}

ExitCode dumpProgram(const std::string& path,
                     std::string text,
                     const Settings& settings,
                     const InterruptFlag& interrupted) {
  Compilation job(settings);
  if (load(job, path, std::move(text), interrupted)) {
    ir::print(std::cout, job.program);
    std::cout.flush();
  }
  job.log.print(job.sources, job.main, settings);
  return job.log.exitCode();
}
}  // namespace

int runDump(const Invocation& invocation) {
  CLI::App app(
      "Shows a CL tape record by record, or a part program as the compiler understands it.",
      "dump");
  Settings settings;
  std::string file;
  app.add_option("FILE", file, "a CL tape or a part program")->required();
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  Result<std::string> bytes = readBytes(file, settings.limits);
  if (!bytes) {
    DiagnosticLog log;
    log.accept(bytes.takeFailure());
    log.print({}, {}, settings);
    return static_cast<int>(log.exitCode());
  }
  return static_cast<int>(
      formatOf(*bytes) == InputFormat::tape
          ? dumpTape(file, *std::move(bytes), settings)
          : dumpProgram(file, *std::move(bytes), settings, invocation.interrupt.flag()));
}

}  // namespace arelem::app
