#pragma once
#include "backend/backend.h"

namespace arelem::backend {

/// Joints of a painting arm over time, as a table: CSV with a line for each interval.
[[nodiscard]] std::unique_ptr<Writer> makeJointTableWriter(std::ostream& out,
                                                           const Context& context,
                                                           DiagnosticSink& sink);
/// The same as curves: path, and place, speed and acceleration of each joint over time, SVG.
[[nodiscard]] std::unique_ptr<Writer> makeJointPlotWriter(std::ostream& out,
                                                          const Context& context,
                                                          DiagnosticSink& sink);

}  // namespace arelem::backend
