#pragma once
#include <optional>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/geometry/tabulated_cylinder.h"

namespace arelem::define {

enum class FitMethod : std::uint8_t {
  spline,    ///< curvature continuous; given tangents are kept
  twoPoint,  ///< tangents given or estimated from circles through three points
  fourPoint  ///< each cubic passes the four points around its chord; tangents jump
};

/// A point of the curve and, where it is given, the direction of its tangent (either sense).
struct CurveNode {
  geometry::Vec2 place = geometry::Vec2::Zero();
  std::optional<geometry::Vec2> tangent;
};

/// Fits the chain of cubics through the nodes and adds the straight intervals at both ends; the
/// frame is left to the caller. Tangents at an end that are not given mirror those of the neighbor
/// in the chord. Needs at least three nodes, neighbors more than tolerance::coincidence apart.
/// Through points that zigzag sharply there may be no curve of continuous curvature: then `remark`
/// tells of the jump that is left.
[[nodiscard]] Result<geometry::TabulatedCylinder> fitCurve(const std::vector<CurveNode>& nodes,
                                                           FitMethod method,
                                                           std::optional<Failure>& remark);

}  // namespace arelem::define
