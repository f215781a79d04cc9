#include <iostream>
#include <set>

#include "app/cl_stream.h"
#include "app/command.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/pipeline.h"
#include "app/report.h"
#include "app/trace.h"
#include "app/word_counts.h"

#include "runtime/tool/profile.h"
#include "runtime/tool/profile_check.h"

namespace arelem::app {

namespace {
struct Tally {
  std::size_t files = 0, failed = 0, errors = 0, warnings = 0;
};

struct CheckOptions {
  Settings settings;
  std::string report;
  bool words = false;
};

/// Large CL text, piece by piece. False when the file is to be read at once.
bool checkPieces(Compilation& job,
                 const std::string& path,
                 WordCounts& words,
                 const InterruptFlag& interrupted) {
  const auto dialect = streamDialect(path, job.settings);
  if (!dialect) {
    return false;
  }
  ClTexts texts;
  ClReading reading(job, texts, path, *dialect, interrupted);
  while (reading.open()) {
    const std::unique_ptr<ClPiece> piece = reading.read();
    if (piece == nullptr) {
      return false;
    }
    std::vector<Span> told;
    for (const Diagnostic& diagnostic : piece->messages) {
      told.push_back(diagnostic.at);
    }
    words.add(piece->program, texts.map(), piece->text, told);
  }
  return reading.finish();
}

/// CUTTER statements are judged where motion begins, which a check does not come to.
void checkCutters(Compilation& job) {
  std::set<std::size_t> told;
  for (const runtime::Action& action : job.evaluation.actions) {
    const auto* p = std::get_if<runtime::Parameter>(&action.body);
    if (p == nullptr || p->word != Word::CUTTER || !told.insert(action.origin.begin).second) {
      continue;
    }
    const auto profile = tool::makeProfile(p->values);
    if (auto bad = profile ? tool::shapeFault(*profile) : std::optional(profile.failure())) {
      job.log.accept(at(action.origin, *std::move(bad)));
    }
  }
}

void checkWhole(Compilation& job,
                const std::string& path,
                WordCounts& words,
                const InterruptFlag& interrupted) {
  if (load(job, path, interrupted) && job.log.errors() == 0) {
    static_cast<void>(evaluate(job, interrupted));
    if (job.program.dialect != spell(frontend::Dialect::cl)) {
      checkCutters(job);
    }
  }
  std::vector<Span> told;
  for (const Diagnostic& diagnostic : job.log.all()) {
    told.push_back(diagnostic.at);
  }
  if (job.sources.size() > 0) {
    words.add(job.program, job.sources, job.sources.text(job.main), told);
  }
}

ExitCode checkOne(const std::string& path,
                  const CheckOptions& options,
                  const InterruptFlag& interrupted,
                  Tally& tally) {
  auto job = std::make_unique<Compilation>(options.settings);
  auto words = std::make_unique<WordCounts>();
  if (!options.report.empty() || !checkPieces(*job, path, *words, interrupted)) {
    job = std::make_unique<Compilation>(options.settings);
    words = std::make_unique<WordCounts>();
    checkWhole(*job, path, *words, interrupted);
  }
  if (!options.report.empty() && !interrupted) {
    writeRunReport(*job, options.report, false);
  }
  if (options.words && !interrupted) {
    words->print(std::cout);
  }
  printTrace(std::cerr, *job);
  job->log.print(job->sources, job->main, options.settings);
  ++tally.files;
  tally.failed += job->log.errors() > 0 ? 1 : 0;
  tally.errors += job->log.errors();
  tally.warnings += job->log.warnings();
  return job->log.exitCode();
}
}  // namespace

int runCheck(const Invocation& invocation) {
  CLI::App app("Reads and evaluates part programs without computing any motion.", "check");
  CheckOptions options;
  Settings& settings = options.settings;
  std::vector<std::string> files;
  app.add_option("FILE", files, "part programs; - is standard input")->required();
  app.add_option("--report", options.report, "what the program uses, as JSON; for one file")
      ->type_name("FILE");
  app.add_flag("--words", options.words,
               "how often each word begins a statement, and what became of it: understood, passed "
               "on, reported");
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (!options.report.empty() && files.size() != 1) {
    printUsageError("check", "`--report` is for one file");
    return static_cast<int>(ExitCode::wrongUse);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  ExitCode result = ExitCode::ok;
  Tally tally;
  for (const std::string& file : files) {
    if (!interrupted) {
      result = worse(result, checkOne(file, options, interrupted, tally));
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
