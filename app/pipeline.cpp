#include "app/pipeline.h"

#include <filesystem>

#include "app/film_warnings.h"
#include "app/library_path.h"
#include "app/source_file.h"
#include "app/stopwatch.h"
#include "app/view/curves.h"

#include "runtime/path/arc_start.h"
#include "runtime/path/chords.h"
#include "runtime/path/curve_needs.h"
#include "runtime/path/feed_override.h"
#include "runtime/path/frame_stage.h"
#include "runtime/path/movnrb.h"
#include "runtime/path/smoother.h"
#include "runtime/path/swarf.h"
#include "runtime/path/transform.h"
#include "runtime/pieces.h"

namespace arelem::app {

namespace {
frontend::Options frontendOptions(const Settings& settings, const InterruptFlag& interrupted) {
  frontend::Options options;
  options.dialect = settings.dialect;
  options.limits = settings.limits;
  options.defines = settings.defines;
  options.libraryPath = settings.libraryPath;
  for (std::string& folder : installedLibrary()) {
    options.libraryPath.push_back(std::move(folder));
  }
  options.interrupted = &interrupted;
  return options;
}
/// Data files lie beside the part program or in the library path.
files::Files dataFiles(Compilation& job) {
  files::Files found;
  found.opened = &job.filesRead;
  found.folders.push_back(std::filesystem::path(job.sources.name(job.main)).parent_path().string());
  found.folders.insert(found.folders.end(), job.settings.libraryPath.begin(),
                       job.settings.libraryPath.end());
  for (std::string& folder : installedLibrary()) {
    found.folders.push_back(std::move(folder));
  }
  found.largest = job.settings.limits.bytes;
  return found;
}
}  // namespace

bool load(Compilation& job, const std::string& path, const InterruptFlag& interrupted) {
  Result<std::string> bytes = readBytes(path, job.settings.limits);
  if (!bytes) {
    job.log.accept(bytes.takeFailure());
    return false;
  }
  return load(job, path, *std::move(bytes), interrupted);
}

bool load(Compilation& job,
          const std::string& path,
          std::string text,
          const InterruptFlag& interrupted) {
  const Stopwatch watch(job.seconds.parse);
  if (std::optional<Failure> objection = objectionToText(path, text)) {
    job.log.accept(*std::move(objection));
    return false;
  }
  job.main = job.sources.add(displayName(path), std::move(text));
  job.program =
      frontend::compile(job.sources, job.main, frontendOptions(job.settings, interrupted), job.log);
  return !interrupted;
}

bool evaluate(Compilation& job, const InterruptFlag& interrupted, bool history) {
  const Stopwatch watch(job.seconds.evaluate);
  job.evaluation = runtime::evaluate(
      job.program,
      {job.settings.limits, &interrupted, dataFiles(job), history, job.progress, job.defined},
      job.log);
  const bool good = job.evaluation.complete && job.log.errors() == 0 && !interrupted;
  if (good) {
    warnOfFilms(job);
  }
  return good;
}

namespace {
/// What is rewritten over the whole program needs all actions at once.
bool needsAll(const std::vector<runtime::Action>& actions) {
  return path::overridesFeeds(actions) || path::firstSwarf(actions).has_value() ||
         path::needsChords(actions);
}

bool isText(const Compilation& job) {
  return job.program.dialect == spell(frontend::Dialect::cl);
}

/// For an evaluation that was done before: files are known, progress and definitions told.
runtime::Options onceMore(Compilation& job, const InterruptFlag& interrupted) {
  runtime::Options options;
  options.limits = job.settings.limits;
  options.interrupted = &interrupted;
  options.files = dataFiles(job);
  options.files.opened = nullptr;
  return options;
}

/// Section 2, of long programs piece by piece beside a second evaluation: that takes less time than
/// the motions, and less memory than their actions.
void run(Compilation& job,
         const runtime::Options& options,
         cl::RecordSink& records,
         const InterruptFlag& interrupted) {
  runtime::Execution execution(options, records, job.log);
  if (job.inPieces) {
    CollectingSink told;
    const runtime::Options again = onceMore(job, interrupted);
    const runtime::Evaluation last = runtime::evaluateInPieces(
        job.program, again, told, [&execution](std::vector<runtime::Action>& actions) {
          execution.feed(actions);
          actions.clear();
        });
    execution.feed(last.actions);
  } else {
    execution.feed(job.evaluation.actions);
  }
  job.motion = execution.finish();
}
}  // namespace

bool evaluateInPieces(Compilation& job, const InterruptFlag& interrupted) {
  if (isText(job)) {
    return evaluate(job, interrupted);
  }
  const Stopwatch watch(job.seconds.evaluate);
  bool whole = false;
  const runtime::Options options{job.settings.limits, &interrupted, dataFiles(job), false,
                                 job.progress,        job.defined};
  job.evaluation = runtime::evaluateInPieces(job.program, options, job.log,
                                             [&](std::vector<runtime::Action>& actions) {
                                               whole = whole || needsAll(actions);
                                               if (!whole) {
                                                 job.inPieces = true;
                                                 actions.clear();
                                               }
                                             });
  const bool good = job.evaluation.complete && job.log.errors() == 0 && !interrupted;
  if (good) {
    warnOfFilms(job);
  }
  if (good && job.inPieces && (whole || needsAll(job.evaluation.actions))) {
    CollectingSink told;
    job.evaluation = runtime::evaluate(job.program, onceMore(job, interrupted), told);
    job.inPieces = false;
  }
  return good && !interrupted;
}

bool execute(Compilation& job,
             cl::RecordSink& records,
             const InterruptFlag& interrupted,
             bool upright) {
  const Stopwatch watch(job.seconds.execute);
  const auto transformer =
      path::makeTransformer(records, job.log, job.settings.limits, &interrupted);
  const auto starts = path::makeArcStart(*transformer);
  const auto smoother = path::makeSmoother(*starts, job.log, &interrupted);
  const bool text = isText(job);
  const std::vector<runtime::Action>& actions = job.evaluation.actions;
  cl::RecordSink* first = smoother.get();
  std::unique_ptr<path::SwarfStage> tilted;
  // CL text that names a swarf section has been tilted by the system that wrote it.
  if (!text && !upright && path::firstSwarf(actions)) {
    tilted = path::makeSwarfStage(*first, job.log);
    first = tilted.get();
  }
  std::unique_ptr<path::ChordStage> chords;
  if (tilted || path::needsChords(actions)) {
    chords = path::makeChordStage(*first, job.log);
    first = chords.get();
  }
  std::unique_ptr<cl::RecordSink> frames;
  std::unique_ptr<cl::RecordSink> splines;
  if (text) {
    frames = frameStage(job.settings, *first, job.log);
    splines = path::makeMovnrbCheck(*frames, job.log);
    first = splines.get();
  }
  std::unique_ptr<path::FeedOverride> feeds;
  if (!text && path::overridesFeeds(actions)) {
    feeds = path::makeFeedOverride(*first, actions);
    first = feeds.get();
  }
  runtime::Options options{job.settings.limits, &interrupted, {}, false, {}, {}, false};
  options.axesFollow = text;
  options.keepsFacts = job.keepsFacts;
  run(job, options, *first, interrupted);
  if (feeds) {
    feeds->finish();
  }
  if (tilted) {
    tilted->finish();
  }
  smoother->finish();
  job.smoothed = smoother->facts();
  transformer->finish();
  return job.motion.complete && job.log.errors() == 0 && !interrupted;
}

std::unique_ptr<cl::RecordSink> frameStage(const Settings& settings,
                                           cl::RecordSink& next,
                                           DiagnosticSink& sink) {
  return path::makeFrameStage(
      next, settings.partFrame ? path::Frames::part : path::Frames::asWritten, sink);
}

backend::Context backendContext(const Compilation& job) {
  backend::Context context;
  context.sources = &job.sources;
  context.program = &job.program;
  context.deck = job.evaluation.deck;
  context.codes = &job.codes;
  for (const runtime::Defined& defined : job.evaluation.defined) {
    if (defined.entity) {
      context.entities.push_back(defined.entity);
      context.curves.push_back(curvesOf(*defined.entity));
    }
  }
  for (const runtime::Printed& p : job.evaluation.printed) {
    context.printed.push_back(
        {p.isn, p.mode, p.title, p.name, p.subscript, p.entity, p.scalar, p.undefined});
  }
  return context;
}

}  // namespace arelem::app
