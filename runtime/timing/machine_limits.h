#pragma once
#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "runtime/timing/transition.h"

namespace arelem::timing {

/// Reads MACHLM/velocity, acceleration, jerk in mm/s, mm/s2, mm/s3. Errors: E0395.
[[nodiscard]] Result<Limits> machineLimits(const cl::Post& post);

}  // namespace arelem::timing
