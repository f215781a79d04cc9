#pragma once
#include "runtime/interpret/item.h"
#include "runtime/interpret/state.h"

namespace arelem::runtime::interpret {

/// VTLAXS and WCORN, whose parameters Section 3 relies on (manual of APT360, 13.4). False after an
/// error, which is reported.
[[nodiscard]] bool checkSwarf(State& state, Word word, const Items& items);

}  // namespace arelem::runtime::interpret
