#pragma once
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

/// Warns of words that a post-processor word is not known to take, as of FLOOD in SPINDL/FLOOD
/// (W0583), and of more or fewer numbers than it takes (W0584): ir/words/post_forms.def. The
/// statement is passed on all the same, since a post-processor may have its own meaning.
void checkPostArguments(State& state, Word word, const Items& items);

}  // namespace arelem::runtime::interpret
