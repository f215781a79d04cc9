#pragma once
#include "app/pipeline.h"

namespace arelem::app {

/// Sets `job.codes`, the numbers of words on CL tapes, as --codes says: a code file by its path or
/// by its name in the library, its suffix may be left out; the vocabulary's without it. False when
/// it cannot be read: diagnosed in the log.
[[nodiscard]] bool readCodes(Compilation& job);

}  // namespace arelem::app
