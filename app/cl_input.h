#pragma once
#include <string>

#include "app/pipeline.h"

/// Files of CL data in any format that can be read: text, CL tape, json.
namespace arelem::app {

enum class InputFormat : std::uint8_t { text, tape, json };

/// By the bytes: the header of a tape's first record holds small 32-bit numbers, so its first bytes
/// have zeros, and a text has none; JSON begins with a brace.
[[nodiscard]] InputFormat formatOf(std::string_view bytes);

/// Hands the records of a file to `records`: those of CL text and part programs are computed, those
/// of a tape or JSON stand there. False after a fault, which is in the log of `job`.
[[nodiscard]] bool readRecords(Compilation& job,
                               const std::string& path,
                               std::string bytes,
                               cl::RecordSink& records,
                               const InterruptFlag& interrupted);

}  // namespace arelem::app
