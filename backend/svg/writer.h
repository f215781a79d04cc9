#pragma once
#include <memory>

#include "backend/backend.h"

namespace arelem::backend {

/// The orthographic views of a picture; automatic: one for a path in a plane, else all.
enum class PictureViews : std::uint8_t { automatic, plan, front, side, all };

/// `--to svg`: a picture of the tool path with the geometry it follows. Plan view, and front and
/// side views when the path leaves a plane. A long path is thinned to what can be seen; the legend
/// says so.
[[nodiscard]] std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                                        const Context& context,
                                                        DiagnosticSink& sink);
/// The same with the views that are asked for, and a warning below the title ("": none).
[[nodiscard]] std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                                        const Context& context,
                                                        PictureViews views,
                                                        std::string warning = "");

}  // namespace arelem::backend
