#include "runtime/timing/machine_limits.h"

#include <array>
#include <cmath>

#include "ir/diag/spline.h"

namespace arelem::timing {

Result<Limits> machineLimits(const cl::Post& post) {
  std::array<double, 3> values{};
  if (post.arguments.size() != values.size()) {
    return fail(diag::MachineLimits, fmt::format("{} parameters", post.arguments.size()));
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double* number = std::get_if<double>(&post.arguments[i]);
    if (number == nullptr || !(*number > 0.0) || !std::isfinite(*number)) {
      return fail(diag::MachineLimits, number == nullptr
                                           ? fmt::format("no number as parameter {}", i + 1)
                                           : fmt::format("{:.9g} as parameter {}", *number, i + 1));
    }
    values[i] = *number;
  }
  return Limits{values[0], values[1], values[2]};
}

}  // namespace arelem::timing
