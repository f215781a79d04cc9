#pragma once
#include <span>

#include "backend/cltape/codes.h"
#include "backend/cltape/post_decode.h"
#include "backend/cltape/word.h"
#include "ir/cl/record.h"

namespace arelem::backend::tape {

/// What is known of the tape: the numbers of its words, and what earlier records say about later ones.
struct DecodeState {
  Codes codes;
  bool withAxis = false;  ///< after MULTAX/ON: six numbers a location
};

/// The body of a record from its class, subclass and words. A class or subclass that is not known
/// here gives cl::Raw, and so does a known one whose words do not fit: then `fault` says why. 1000
/// gives cl::Card.
[[nodiscard]] Decoded decode(int type,
                             int sub,
                             std::span<const TapeWord> words,
                             DecodeState& state);

}  // namespace arelem::backend::tape
