#pragma once
#include "ir/define/matcher.h"
#include "runtime/define/define.h"

namespace arelem::define {

/// What the forms of definitions see of a parameter.
[[nodiscard]] Symbol symbolOf(const Parameter& parameter);

}  // namespace arelem::define
