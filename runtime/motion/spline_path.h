#pragma once
#include <vector>

#include "ir/diag/result.h"
#include "ir/space/vector.h"
#include "runtime/motion/records.h"

namespace arelem::motion {

/// The locations of GOTO/spline: every chord is within `band` of the curve, both ends included.
/// Errors: no band.
[[nodiscard]] Result<std::vector<Vec3>> alongSpline(const Entity& curve, double band);

/// Puts out the curve and the locations behind the first one, where the tool is.
void putSpline(RecordWriter& writer,
               const Entity& curve,
               const std::vector<Vec3>& path,
               const Vec3& axis,
               bool withAxis);

[[nodiscard]] double lengthOf(const std::vector<Vec3>& path);

}  // namespace arelem::motion
