#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// `--to svg`: a picture of the tool path with the geometry it follows. Plan view, and front and
/// side views when the path leaves a plane. A long path is thinned to what can be seen; the legend
/// says so.
[[nodiscard]] std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                                        const Context& context,
                                                        DiagnosticSink& sink);

}  // namespace arelem::backend
