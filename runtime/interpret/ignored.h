#pragma once
#include "runtime/run.h"

namespace arelem::runtime {

/// The message of what has no effect (W0474).
[[nodiscard]] Diagnostic noEffect(const Ignored& ignored);

}  // namespace arelem::runtime
