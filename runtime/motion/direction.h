#pragma once
#include "ir/diag/result.h"
#include "ir/program/statement.h"
#include "ir/space/vector.h"

namespace arelem::motion {

/// The wanted direction W of a GO word, from the sense of direction and the tool axis (spec 4.5). A
/// forward direction along the axis gives way to the last displacement across it.
[[nodiscard]] Result<Vec3> wantedDirection(ir::Heading heading,
                                           const std::optional<Vec3>& forward,
                                           const std::optional<Vec3>& lastAcross,
                                           const Vec3& axis);

/// The start direction: the tangent common to both surfaces, turned towards W; W itself where the
/// normals are parallel. Fails within 2 degrees of square to W.
[[nodiscard]] Result<Vec3> startDirection(ir::Heading heading,
                                          const Vec3& wanted,
                                          const Vec3& partNormal,
                                          const Vec3& driveNormal,
                                          const Vec3& toolEnd);

[[nodiscard]] std::string_view spell(ir::Heading heading);  ///< "GOLFT", ...

}  // namespace arelem::motion
