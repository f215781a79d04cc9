#pragma once
#include <string>

#include "ir/cl/record.h"

namespace arelem::backend {

/// Appends the lines of one record as CLPRNT printed it, without its RECNO line:
/// apt-language.md 6.3.
void appendRecordLines(std::string& text, const cl::Body& body);

}  // namespace arelem::backend
