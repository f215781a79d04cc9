#pragma once
#include <memory>

#include "ir/cl/record.h"
#include "ir/diag/diagnostic.h"

namespace arelem::path {

/// MOVNRB of Creo: a path as a B-spline and, behind MOVNRB/NEXT, as the locations that the same
/// curve was divided into.
///   MOVNRB/ON, order, knots, weights, control points, length
///   MOVNRB/1, knot ...        MOVNRB/2, x,y,z of the control points ...
///   MOVNRB/NEXT               GOTO/ ...                 MOVNRB/OFF
/// (five axes: MOVNRB/3 has the control points of a second curve along the tool)
/// The locations are the path here, and all statements pass: a control that knows splines may take
/// the curve. Counts that do not fit (W0596) and locations off the curve (W0597) are warnings.
[[nodiscard]] std::unique_ptr<cl::RecordSink> makeMovnrbCheck(cl::RecordSink& next,
                                                              DiagnosticSink& sink);

}  // namespace arelem::path
