#pragma once
#include "runtime/tool/triangle_gap.h"

namespace arelem::tool {

/// The same as `gapOf`, but a gap above `enough` is not told exactly: only that it is above, with
/// a tangent that is right.
[[nodiscard]] TriangleGap gapOf(const PlacedBody& body, const Facet& triangle, double enough);

}  // namespace arelem::tool
