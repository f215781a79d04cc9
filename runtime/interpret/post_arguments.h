#pragma once
#include "runtime/interpret/item.h"

namespace arelem::runtime::interpret {

/// Warns of words of the vocabulary that a post-processor word is not known to take, as of FLOOD in
/// SPINDL/FLOOD (W0583). Only the words that steer every machine are looked at; numbers, and words
/// that the vocabulary does not have, may mean anything to a post-processor.
void checkPostArguments(State& state, Word word, const Items& items);

}  // namespace arelem::runtime::interpret
