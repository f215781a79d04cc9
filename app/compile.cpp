#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/batch.h"
#include "app/cl_input.h"
#include "app/cl_stream.h"
#include "app/code_file.h"
#include "app/command.h"
#include "app/depfile.h"
#include "app/library_file.h"
#include "app/machine.h"
#include "app/options.h"
#include "app/output_plan.h"
#include "app/output_set.h"
#include "app/path_options.h"
#include "app/pipeline.h"
#include "app/progress_bar.h"
#include "app/report.h"
#include "app/source_file.h"
#include "app/stopwatch.h"
#include "app/trace.h"
#include "app/worker.h"

#include "runtime/path/arc_fit.h"

namespace arelem::app {

namespace {
struct CompileOptions {
  Settings settings;
  std::vector<std::string> inputs;
  OutputChoice outputs;
  bool keepGoing = false;
  int decimals = -1;
  MachineChoice machine;
  double fitShare = 0.0;
  std::string depfile;
  BatchChoice batch;
  int tally = -1;  ///< descriptor of --tally: this is the worker of a batch
};

void addOptions(CLI::App& app, CompileOptions& options) {
  app.add_option("FILE", options.inputs, "part programs; - is standard input")->required();
  app.add_option("-o,--output", options.outputs.files,
                 "output file, - is standard output; repeat it for several formats")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--to", options.outputs.formats,
                 "output format (see arelem targets); default from the suffix, else cl")
      ->type_name("FORMAT")
      ->allow_extra_args(false);
  app.add_option("--out-dir", options.outputs.folder,
                 "folder for the outputs, made if missing; names follow the inputs")
      ->type_name("DIR");
  app.add_option("--report", options.outputs.report, "what each statement did, as JSON")
      ->type_name("FILE");
  addMachineOptions(app, options.machine);
  app.add_option("--decimals", options.decimals, "decimals of lengths in CL text; default: exact")
      ->check(CLI::Range(1, 15))
      ->type_name("N");
  app.add_flag("--keep-going", options.keepGoing,
               "after motion errors write what there is to FILE.partial");
  app.add_flag("--force", options.outputs.force, "binary formats may go to a terminal");
  app.add_option("-j,--jobs", options.batch.jobs,
                 "compiles so many programs at once, each in a process of its own; 0: as many as "
                 "there are processors")
      ->type_name("N");
  app.add_option("--manifest", options.batch.manifest,
                 "inputs and outputs of a batch with their SHA-256, as JSON; default: "
                 "manifest.json in the folder of --out-dir")
      ->type_name("FILE");
  app.add_option("--depfile", options.depfile,
                 "a rule for make and ninja: what the outputs were made from; for one program")
      ->type_name("FILE");
  app.add_option("--tally", options.tally)->group("");
  addFitOption(app, options.fitShare);
  addSourceOptions(app, options.settings);
  addMessageOptions(app, options.settings);
}

std::size_t statementCount(const ir::Program& program) {
  std::size_t count = 0;
  for (const ir::Block& block : program.blocks) {
    count += block.statements.size();
  }
  return count;
}

std::uint32_t lineOf(const Compilation& job, const Span& at) {
  return job.sources.locate(at.buffer, at.begin).line;
}

void printSummary(const PlannedJob& plan,
                  const Compilation& job,
                  std::size_t statements,
                  const OutputSet& outputs) {
  const auto& spent = job.seconds;
  const double seconds = spent.parse + spent.evaluate + spent.execute + spent.write;
  std::cerr
      << fmt::format(
             "{}: {} statements, {} executed, {} motions, {} cut vectors, path length {:.6g}\n",
             plan.input == "-" ? "<stdin>" : plan.input, statements, job.evaluation.steps,
             job.motion.motions, job.motion.cutVectors, job.motion.length)
      << fmt::format("   {:.1f} ms: parse {:.1f}, geometry {:.1f}, motion {:.1f}, files {:.1f}\n",
                     seconds * 1e3, spent.parse * 1e3, spent.evaluate * 1e3, spent.execute * 1e3,
                     spent.write * 1e3);
  if (job.time && job.time->moves > 0) {
    std::cerr << fmt::format(
        "   machining time {:.3f} s: cutting {:.3f}, rapid {:.3f}, dwell {:.3f}, "
        "{} tool changes {:.3f}\n",
        job.time->total(), job.time->cutting, job.time->rapid, job.time->dwell, job.time->changes,
        job.time->toolChanges);
  }
  for (const path::SmoothFact& fact : job.smoothed) {
    std::cerr << fmt::format(
        "   smoothed from line {}: largest curvature {:.4g} to {:.4g}, mean {:.4g} to {:.4g}, "
        "length {:.6g} to {:.6g}, {:.3f} to {:.3f} s, within {:.3g}\n",
        lineOf(job, fact.origin), fact.mostBefore, fact.mostAfter, fact.meanBefore, fact.meanAfter,
        fact.lengthBefore, fact.lengthAfter, fact.secondsBefore, fact.secondsAfter, fact.deviation);
  }
  for (const OutputSet::Written& file : outputs.written()) {
    std::cerr << fmt::format("   {} ({} bytes)\n", file.path == "-" ? "standard output" : file.path,
                             file.bytes);
  }
}

bool needsMotion(const PlannedJob& plan) {
  return std::any_of(plan.outputs.begin(), plan.outputs.end(),
                     [](const PlannedOutput& output) { return output.target->needsMotion; });
}

bool needsProgram(const PlannedJob& plan) {
  return std::any_of(plan.outputs.begin(), plan.outputs.end(),
                     [](const PlannedOutput& output) { return output.target->needsProgram; });
}

/// Sends records to the outputs and, for the summary, to the clock.
class Timed : public cl::RecordSink {
 public:
  Timed(cl::RecordSink& outputs, const timing::Machine& machine, bool runs)
      : outputs_(outputs), timer_(machine, untold_), runs_(runs) {}
  void accept(const cl::Record& record) override {
    outputs_.accept(record);
    if (runs_) {
      timer_.accept(record);
    }
  }
  /// None when a feed is missing; `arelem time` tells where.
  std::optional<timing::TimeTable> finish() {
    std::optional<timing::TimeTable> table = timer_.finish();
    return runs_ && untold_.errors() == 0 ? table : std::nullopt;
  }

 private:
  cl::RecordSink& outputs_;
  CollectingSink untold_;
  timing::CutTimer timer_;
  bool runs_;
};

/// The way of records to the outputs: arcs are fitted, and the summary takes their times.
class Delivery {
 public:
  Delivery(OutputSet& outputs, const robot::Machine* machine, const CompileOptions& options)
      : timed_(outputs, timingMachine(machine), options.settings.verbose),
        fitter_(path::makeArcFitter(timed_, options.fitShare)) {}
  [[nodiscard]] cl::RecordSink& first() { return *fitter_; }
  /// After the last record.
  void finish(Compilation& job) {
    fitter_->finish();
    job.time = timed_.finish();
  }

 private:
  Timed timed_;
  std::unique_ptr<path::ArcFitter> fitter_;
};

/// Messages, the tally of a batch and the summary.
void tellEnd(Compilation& job,
             const PlannedJob& plan,
             std::size_t statements,
             const OutputSet& outputs,
             const CompileOptions& options) {
  job.log.print(job.sources, job.main, options.settings);
  if (options.tally >= 0) {
    writeTally(options.tally, job.log.errors(), job.log.warnings(), job.motion.cutVectors);
  }
  if (options.settings.verbose && !options.settings.quiet) {
    printSummary(plan, job, statements, outputs);
  }
}

/// From evaluated program to files. Nothing gets a final name unless all went well.
void produce(Compilation& job,
             OutputSet& outputs,
             const PlannedJob& plan,
             const CompileOptions& options,
             const InterruptFlag& interrupted) {
  backend::Context context = backendContext(job);
  context.decimals = options.decimals;
  Result<std::optional<robot::Machine>> machine = loadMachine(options.machine, job.settings);
  if (!machine) {
    job.log.accept(machine.takeFailure());
    return;
  }
  context.machine = machine->has_value() ? &**machine : nullptr;
  if (!outputs.open(plan.outputs, context)) {
    return;
  }
  Delivery delivery(outputs, context.machine, options);
  const bool whole = !needsMotion(plan) || execute(job, delivery.first(), interrupted);
  delivery.finish(job);
  if (whole || (options.keepGoing && !interrupted)) {
    const Stopwatch watch(job.seconds.write);
    static_cast<void>(outputs.close(!whole));
  }
}

/// From the records of a tape or a json file to other formats.
void rewrite(Compilation& job,
             OutputSet& outputs,
             const PlannedJob& plan,
             ClFile& file,
             const CompileOptions& options,
             const InterruptFlag& interrupted) {
  backend::Context context = backendContext(job);
  context.program = nullptr;
  context.decimals = options.decimals;
  if (!outputs.open(plan.outputs, context)) {
    return;
  }
  const auto fitter = path::makeArcFitter(outputs, options.fitShare);
  const bool whole = readRecords(job, file, *fitter, interrupted);
  fitter->finish();
  if (whole || (options.keepGoing && !interrupted)) {
    static_cast<void>(outputs.close(!whole));
  }
}

/// What must be done with a whole program.
bool wantsAll(const PlannedJob& plan, const CompileOptions& options) {
  return !plan.report.empty() || !options.depfile.empty() || !options.machine.file.empty() ||
         !options.machine.compat.empty() || needsProgram(plan);
}

/// Large CL text, piece by piece. None when the file is to be read at once.
std::optional<ExitCode> stream(const PlannedJob& plan,
                               const CompileOptions& options,
                               const InterruptFlag& interrupted) {
  const auto dialect =
      wantsAll(plan, options) ? std::nullopt : streamDialect(plan.input, options.settings);
  if (!dialect) {
    return std::nullopt;
  }
  Compilation job(options.settings);
  CollectingSink messages;
  OutputSet outputs(messages);
  backend::Context context = backendContext(job);
  context.decimals = options.decimals;
  if (!readCodes(job) || !outputs.open(plan.outputs, context)) {
    return std::nullopt;  // and then with a message
  }
  Delivery delivery(outputs, nullptr, options);
  ClTexts texts;
  ClStreamEnd end{delivery.first(), messages, texts};
  end.close = [&] {
    delivery.finish(job);
    return outputs.close(false);
  };
  if (streamCl(job, plan.input, *dialect, end, interrupted) == Streamed::refused) {
    return std::nullopt;
  }
  tellEnd(job, plan, end.statements, outputs, options);
  return job.log.exitCode();
}

/// Whatever kind of file the input is.
void compileInto(OutputSet& outputs,
                 Compilation& job,
                 const PlannedJob& plan,
                 const CompileOptions& options,
                 const InterruptFlag& interrupted) {
  if (!readCodes(job)) {
    return;
  }
  Result<ClFile> file = ClFile::open(plan.input, options.settings.limits);
  if (!file) {
    job.log.accept(file.takeFailure());
  } else if (file->format() != InputFormat::text) {
    rewrite(job, outputs, plan, *file, options, interrupted);
  } else if (Result<std::string> text = file->text(); !text) {
    job.log.accept(text.takeFailure());
  } else if (load(job, plan.input, *std::move(text), interrupted) &&
             evaluateInPieces(job, interrupted)) {
    job.keepsFacts = !plan.report.empty();
    produce(job, outputs, plan, options, interrupted);
  }
}

/// The machine file of --machine, where it was found.
std::vector<std::string> machineFiles(const CompileOptions& options) {
  if (options.machine.file.empty()) {
    return {};
  }
  const Result<LibraryFile> file =
      readLibraryFile(options.machine.file, options.settings, "machines");
  return file ? std::vector{(*file).name} : std::vector<std::string>{};
}

ExitCode compileOne(const PlannedJob& plan,
                    const CompileOptions& options,
                    const InterruptFlag& interrupted) {
  if (const std::optional<ExitCode> code = stream(plan, options, interrupted)) {
    return *code;
  }
  Compilation job(options.settings);
  job.progress = progressOnTerminal();
  OutputSet outputs(job.log);
  compileInto(outputs, job, plan, options, interrupted);
  if (!plan.report.empty() && !interrupted) {
    writeRunReport(job, plan.report, options.settings.verbose);
  }
  if (!options.depfile.empty() && job.log.errors() == 0 && !interrupted) {
    writeDepfile(job, plan, machineFiles(options), options.depfile);
  }
  printTrace(std::cerr, job);
  tellEnd(job, plan, statementCount(job.program), outputs, options);
  return job.log.exitCode();
}

/// Makes --out-dir. An error is told and ends the command.
bool makeFolder(const std::string& folder) {
  std::error_code error;
  if (!folder.empty()) {
    std::filesystem::create_directories(folder, error);
  }
  if (error) {
    printError("cannot make the folder `" + folder + "`: " + error.message());
  }
  return !error;
}
}  // namespace

int runCompile(const Invocation& invocation) {
  CLI::App app(
      "Compiles part programs. Without -o and --out-dir the result, CL text, goes to standard "
      "output.\n"
      "Outputs are complete or absent: an error leaves older files as they were.",
      "compile");
  CompileOptions options;
  addOptions(app, options);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  if (!options.depfile.empty() && options.inputs.size() != 1) {
    printUsageError("compile", "`--depfile` is for one program");
    return static_cast<int>(ExitCode::wrongUse);
  }
  std::vector<PlannedJob> jobs;
  if (const auto refusal = planOutputs(options.inputs, options.outputs, jobs)) {
    if (refusal->code == ExitCode::wrongUse) {
      printUsageError("compile", refusal->text);
    } else {
      printError(refusal->text);
    }
    return static_cast<int>(refusal->code);
  }
  if (!makeFolder(options.outputs.folder)) {
    return static_cast<int>(ExitCode::outputNotWritten);
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  if (options.batch.jobs || !options.batch.manifest.empty()) {
    const std::vector<std::string> words =
        optionsOnly(app, invocation.words, {"-j", "--jobs", "--manifest", "-v", "--verbose"});
    return static_cast<int>(runBatch(jobs, words, options.batch, options.outputs.folder,
                                     options.settings, interrupted));
  }
  ExitCode result = ExitCode::ok;
  for (const PlannedJob& job : jobs) {
    if (!interrupted) {
      result = worse(result, compileOne(job, options, interrupted));
    }
  }
  return static_cast<int>(result);
}

}  // namespace arelem::app
