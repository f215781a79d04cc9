#pragma once
#include <istream>
#include <string_view>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::backend {

/// Reads the motion records of a `json` output and the circles before them: one record a line, or
/// one object whose `cl` is the list of records. Of other records only their statement number is
/// kept (as cl::Card). One line is in memory at a time. False after a fault, which is reported with
/// its line.
bool readJsonRecords(std::istream& in,
                     std::string_view file,
                     cl::RecordSink& records,
                     DiagnosticSink& sink);

}  // namespace arelem::backend
