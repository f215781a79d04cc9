#pragma once
#include <memory>
#include <optional>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::path {

/// Puts cut vectors in the place of arcs and path splines, for what knows only straight moves. The
/// vectors end on the curve and leave it by at most INTOL + OUTTOL of the records so far (0.0005
/// part units before any). The circle of an arc stays before its vectors, as along a drive surface;
/// NURBS, KNOT and CNTRL go.
class ChordStage : public cl::RecordSink {};

/// Errors of splines (knots that do not rise) go to `sink`; the spline is then left out.
/// `sag`, for what must judge the curve itself: the vectors leave it by at most that, part units,
/// whatever the tolerances, and those of one curve are one record.
[[nodiscard]] std::unique_ptr<ChordStage> makeChordStage(cl::RecordSink& next,
                                                         DiagnosticSink& sink,
                                                         std::optional<double> sag = std::nullopt);

}  // namespace arelem::path
