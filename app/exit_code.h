#pragma once
#include "ir/diag/diagnostic.h"

namespace arelem::app {

/// What the process returns. The list is part of the contract with scripts: docs/manual/cli.md.
enum class ExitCode : int {
  ok = 0,
  programHasErrors = 1,
  wrongUse = 2,
  inputUnreadable = 3,
  geometryUnsolvable = 4,
  verificationFailed = 5,
  outputNotWritten = 6,
  limitReached = 7,
  internalError = 70,
  interrupted = 130,
  terminated = 143
};

/// The exit code that one error asks for, by the hundreds of its code.
[[nodiscard]] ExitCode exitCodeFor(const DiagRow& row);

/// Of two results of one run the one to report: an interrupt before a limit before unreadable input
/// before errors of the program before unsolvable geometry before the rest.
[[nodiscard]] ExitCode worse(ExitCode a, ExitCode b);

}  // namespace arelem::app
