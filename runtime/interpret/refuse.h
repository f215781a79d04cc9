#pragma once
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

/// REFUSE: a macro cannot do what its CALL asks; an error at the CALL, and nothing more is
/// executed.
void refuse(State& state, const Items& items);

}  // namespace arelem::runtime::interpret
