#pragma once
#include "ir/diag/kind.h"

namespace arelem::diag {
#define ARELEM_DIAG ARELEM_DIAG_KIND
#include "ir/diag/words.def"
#undef ARELEM_DIAG
}  // namespace arelem::diag
