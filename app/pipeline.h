#pragma once
#include <memory>
#include <string>

#include "app/messages.h"
#include "app/settings.h"

#include "backend/backend.h"
#include "backend/cltape/codes.h"
#include "runtime/path/smoother.h"
#include "runtime/run.h"
#include "runtime/timing/cut_timer.h"

/// The one way through the house: source -> program -> evaluation -> records. Commands differ only
/// in how far they go and in what they do with the result.
namespace arelem::app {

/// Everything that is known about one input; each stage fills in its part.
struct Compilation {
  explicit Compilation(const Settings& given) : settings(given) {}

  const Settings& settings;
  runtime::ProgressCall progress;   ///< of long searches; may be empty
  runtime::DefinitionCall defined;  ///< told of each definition; may be empty
  SourceMap sources;
  BufferId main;
  std::vector<std::string> filesRead;  ///< data files that definitions named
  DiagnosticLog log;
  backend::tape::Codes codes;  ///< of tapes that are read or written
  ir::Program program;
  runtime::Evaluation evaluation;
  bool inPieces = false;   ///< its actions are only the last: `execute` evaluates again
  bool keepsFacts = true;  ///< of each motion; without, only those under DEBUG
  runtime::MotionOutcome motion;
  std::vector<path::SmoothFact> smoothed;
  std::optional<timing::TimeTable> time;  ///< of the summary; none where it was not asked for
  struct {
    double parse = 0.0, evaluate = 0.0, execute = 0.0, write = 0.0;  ///< wall time of each stage
  } seconds;
};

/// Reads the input and parses it. False when there is nothing to go on with: diagnosed in the log.
[[nodiscard]] bool load(Compilation& job,
                        const std::string& path,
                        const InterruptFlag& interrupted);
/// The same for a text that was read already; `path` is used in messages.
[[nodiscard]] bool load(Compilation& job,
                        const std::string& path,
                        std::string text,
                        const InterruptFlag& interrupted);

/// Section 1. False when the program has errors and must not be executed.
/// `history`: every definition is kept for `job.evaluation.history`.
[[nodiscard]] bool evaluate(Compilation& job,
                            const InterruptFlag& interrupted,
                            bool history = false);

/// The same for `execute` alone: the actions of long programs are not kept.
[[nodiscard]] bool evaluateInPieces(Compilation& job, const InterruptFlag& interrupted);

/// Sections 2 and 3: cutter-location records, transformed, go to `records`.
/// False when a motion failed; the records are then incomplete. With `upright` swarf sections
/// (VTLAXS) stay as they were before Section 3.
[[nodiscard]] bool execute(Compilation& job,
                           cl::RecordSink& records,
                           const InterruptFlag& interrupted,
                           bool upright = false);

/// The stage of --frame, for text of CAM systems.
[[nodiscard]] std::unique_ptr<cl::RecordSink> frameStage(const Settings& settings,
                                                         cl::RecordSink& next,
                                                         DiagnosticSink& sink);

/// What a back end may look at beside the records. Valid as long as the job.
[[nodiscard]] backend::Context backendContext(const Compilation& job);

}  // namespace arelem::app
