#include "backend/cltape/dump.h"

#include <iostream>
#include <sstream>

#include "app/command.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/source_file.h"

namespace arelem::app {

namespace {
/// The header of a tape's first record holds small 32-bit numbers, so its first bytes have zeros; a
/// text has none.
bool looksLikeTape(std::string_view bytes) {
  return bytes.substr(0, 16).find('\0') != std::string_view::npos;
}

ExitCode dumpTape(const std::string& path, std::string bytes, const Settings& settings) {
  SourceMap sources;
  const BufferId main = sources.add(displayName(path), "");
  DiagnosticLog log;
  std::istringstream in(std::move(bytes));
  backend::dump(in, std::cout, log, settings.limits);
  std::cout.flush();
  log.print(sources, main, settings);
  return log.exitCode();
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
  return static_cast<int>(looksLikeTape(*bytes) ? dumpTape(file, *std::move(bytes), settings)
                                                : dumpProgram(file, *std::move(bytes), settings,
                                                              invocation.interrupt.flag()));
}

}  // namespace arelem::app
