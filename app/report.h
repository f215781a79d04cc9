#pragma once
#include <string>

#include "app/pipeline.h"

namespace arelem::app {

/// Writes the account of the run (--report): one entry for each motion statement, however often it
/// ran. Failures go to the log of the job. With `timing` the document differs from run to run.
void writeRunReport(Compilation& job, const std::string& path, bool timing);

}  // namespace arelem::app
