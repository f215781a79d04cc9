#pragma once
#include "runtime/spray/offset.h"

namespace arelem::spray {

/// The offset curve of an outline for an elliptical footprint: the border of SprayedArea, where the
/// gun is switched. Each edge is moved out by its own distance, the support of the ellipse, corners
/// are mitred; where offset edges cross, the curve goes round the union of what each edge adds.
/// Exact boolean operations (CGAL); corners are rounded at the end. Curves that enclose what is
/// sprayed run counterclockwise, those around what is not clockwise. Source: Bartlett 3.3.3.
[[nodiscard]] Outline offsetCurve(const Outline& outline,
                                  const Footprint& footprint,
                                  double sharpest);

}  // namespace arelem::spray
