#include <iostream>

#include "app/command.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/word_counts.h"

namespace arelem::app {

namespace {
struct Tally {
  std::size_t files = 0, failed = 0, errors = 0, warnings = 0;
};

ExitCode checkOne(const std::string& path,
                  const Settings& settings,
                  const std::string& report,
                  bool words,
                  const InterruptFlag& interrupted,
                  Tally& tally) {
  Compilation job(settings);
  if (load(job, path, interrupted) && job.log.errors() == 0) {
    static_cast<void>(evaluate(job, interrupted));
  }
  if (!report.empty() && !interrupted) {
    writeRunReport(job, report, false);
  }
  if (words && !interrupted) {
    printWordCounts(std::cout, job);
  }
  printTrace(std::cerr, job);
  job.log.print(job.sources, job.main, settings);
  ++tally.files;
  tally.failed += job.log.errors() > 0 ? 1 : 0;
  tally.errors += job.log.errors();
  tally.warnings += job.log.warnings();
  return job.log.exitCode();
}
}  // namespace

int runCheck(const Invocation& invocation) {
  CLI::App app("Reads and evaluates part programs without computing any motion.", "check");
  Settings settings;
  std::vector<std::string> files;
  std::string report;
  bool words = false;
  app.add_option("FILE", files, "part programs; - is standard input")->required();
  app.add_option("--report", report, "what the program uses, as JSON; for one file")
      ->type_name("FILE");
  app.add_flag("--words", words,
               "how often each word begins a statement, and what became of it: understood, passed "
               "on, reported");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (!report.empty() && files.size() != 1) {
    printUsageError("check", "`--report` is for one file");
    return static_cast<int>(ExitCode::wrongUse);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  ExitCode result = ExitCode::ok;
  Tally tally;
  for (const std::string& file : files) {
    if (!interrupted) {
      result = worse(result, checkOne(file, settings, report, words, interrupted, tally));
    }
  }
  if (!settings.quiet && settings.format != DiagnosticFormat::json) {
    std::cerr << fmt::format("arelem: {} checked, {} with errors: {}, {}\n",
                             counted(tally.files, "file"), tally.failed,
                             counted(tally.errors, "error"), counted(tally.warnings, "warning"));
  }
  return static_cast<int>(result);
}

}  // namespace arelem::app
