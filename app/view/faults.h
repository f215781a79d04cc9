#pragma once
#include <vector>

#include "app/pipeline.h"

#include "backend/fault_mark.h"
#include "ir/cl/record.h"

namespace arelem::app {

/// The motion statements of the program itself that have errors, at most `mostFaults`, in the order
/// of the path. `records`: what could be computed.
[[nodiscard]] std::vector<backend::FaultMark> faultsOf(const Compilation& job,
                                                       const cl::Recording& records);

inline constexpr std::size_t mostFaults = 60;

}  // namespace arelem::app
