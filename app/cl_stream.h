#pragma once
#include <string>

#include "app/pipeline.h"

namespace arelem::app {

/// How a piecewise reading ended.
enum class Streamed : std::uint8_t {
  whole,    ///< everything went to the records, without a message
  refused,  ///< the text must be read at once: nothing may be kept of what was put out
};

/// Reads CL text of a CAM system piece by piece, so that its size does not matter: text, program,
/// actions and records of a piece are gone before the next. Only for statements whose meaning does
/// not reach back or forward (locations, arcs, post words, texts); the first definition, loop,
/// message or end of file within a statement refuses, and the file is to be read as any other
/// program. Sums go to `job.motion`, times to `job.seconds`.
[[nodiscard]] Streamed streamCl(Compilation& job,
                                const std::string& path,
                                cl::RecordSink& records,
                                std::size_t& statements,
                                const InterruptFlag& interrupted);

/// Whether a file is worth it: large, regular, and CL text by its first lines or by --dialect.
[[nodiscard]] bool isLargeCl(const std::string& path, const Settings& settings);

}  // namespace arelem::app
