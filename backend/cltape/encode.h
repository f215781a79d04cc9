#pragma once
#include <vector>

#include "backend/cltape/codes.h"
#include "backend/cltape/word.h"
#include "ir/cl/record.h"

namespace arelem::backend::tape {

/// Class, subclass and words of one record, without its number.
struct Encoded {
  int type = 0;
  int sub = 0;
  std::vector<TapeWord> words;
};

/// Words of a body; `out` is reused. A motion is written as it is: the caller splits what is too
/// long. Source: record layout of the CL tape of the APT360 port, extended by UNITS (9000/9), words
/// without a code as text, and post words outside the vocabulary (2000/0, the word as text first, where
/// `codes` has no number for it).
void encode(const cl::Body& body, const Codes& codes, Encoded& out);

/// Most numbers of one 5000 record: 80 locations of three numbers or 40 of six.
inline constexpr std::size_t motionNumbers = 240;

/// The code under which a minor word can be written so that it is read back as the same word.
[[nodiscard]] std::optional<int> modifierCode(Word word);
/// The minor word with this code: one of the old vocabulary before one of later systems.
[[nodiscard]] std::optional<Word> modifierOf(int code);

}  // namespace arelem::backend::tape
