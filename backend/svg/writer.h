#pragma once
#include <memory>
#include <string>
#include <vector>

#include "backend/backend.h"
#include "backend/fault_mark.h"

namespace arelem::backend {

/// The orthographic views of a picture; automatic: one for a path in a plane, else all.
enum class PictureViews : std::uint8_t { automatic, plan, front, side, all };

/// `--to svg`: a picture of the tool path with the geometry it follows. Plan view, and front and
/// side views when the path leaves a plane. A long path is thinned to what can be seen; the legend
/// says so.
[[nodiscard]] std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                                        const Context& context,
                                                        DiagnosticSink& sink);
/// What a picture of a program with errors says about them.
struct Shortcomings {
  std::string warning;           ///< below the title; "": none
  std::vector<FaultMark> marks;  ///< places of the path
  std::string remark;            ///< behind the extents; "": none
};
/// The same with the views that are asked for. The shortcomings are looked at when the writer
/// finishes.
[[nodiscard]] std::unique_ptr<Writer> makePictureWriter(std::ostream& out,
                                                        const Context& context,
                                                        PictureViews views,
                                                        const Shortcomings& shortcomings);

}  // namespace arelem::backend
