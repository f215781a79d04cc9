#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/pipeline.h"

#include "ir/cl/record.h"

namespace arelem::app::repl {

/// The program of a session, compiled and executed as a file would be.
struct Run {
  explicit Run(const Settings& settings) : job(settings) {}

  Compilation job;
  /// Shared with the run before it where no motion was added.
  std::shared_ptr<const cl::Recording> path = std::make_shared<cl::Recording>();
  /// Where the last motion stands, if it waits for the next one, which tells where it ends.
  std::optional<Span> waiting;
};

/// What came of the statements that were added to a run.
struct Verdict {
  enum class State : std::uint8_t { good, open, refused, interrupted };
  State state = State::good;
  std::vector<Diagnostic> found;  ///< not known from the run before
  bool unreadable = false;        ///< refused for the sake of one line, whatever stands before it
};

/// Compiles `text` under the name `name`. Of what it reports only that is found which `before`
/// did not report; a missing FINI is none of it. `open`: a `$`, a loop, a macro or a block waits
/// for its end.
[[nodiscard]] Verdict carryOut(Run& run,
                               const Run* before,
                               const std::string& name,
                               std::string text,
                               const InterruptFlag& interrupted);

}  // namespace arelem::app::repl
