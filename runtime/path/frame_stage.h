#pragma once
#include <memory>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::path {

/// What becomes of the places of a CL file that its MSYS, ROTABL, LOCAL_ORIGIN and CATIA0 posts put
/// into frames.
enum class Frames {
  asWritten,  ///< they stay; a path that runs through several frames is a warning (W0580)
  part  ///< they are brought into the frame of the part; the posts stay, without shift and turn
};

/// With Frames::part locations get six numbers, and MULTAX stands before them, from where a frame
/// turns the tool axis. A ROTABL of a form that names no turn, and a frame whose axes are not
/// square, are a warning (W0581): places stay as they are.
[[nodiscard]] std::unique_ptr<cl::RecordSink> makeFrameStage(cl::RecordSink& next,
                                                             Frames frames,
                                                             DiagnosticSink& sink);

}  // namespace arelem::path
