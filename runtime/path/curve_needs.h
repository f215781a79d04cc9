#pragma once
#include <vector>

#include "runtime/interpret/action.h"

namespace arelem::path {

/// Whether arcs and splines must become cut vectors before SMOOTH, or before a TRACUT or COPY whose
/// matrix makes no circle of a circle.
[[nodiscard]] bool needsChords(const std::vector<runtime::Action>& actions);

}  // namespace arelem::path
