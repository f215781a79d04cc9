#pragma once
#include <span>
#include <vector>

#include "ir/define/forms.h"
#include "ir/define/pattern.h"

/// What may stand behind the first parameters of a definition or statement: for completion, and for
/// the other words that could stand in the place of one.
namespace arelem::define {

struct Continuation {
  std::vector<Expectation> wanted;  ///< each once, in the order of the table
  bool possible = false;            ///< the parameters so far begin some pattern
  bool mayEnd = false;              ///< they are a whole one
};

/// Behind these parameters of one pattern.
[[nodiscard]] Continuation continuation(const Pattern& pattern, std::span<const Symbol> parameters);
/// Behind these parameters of any form of the noun.
[[nodiscard]] Continuation continuation(Word noun, std::span<const Symbol> parameters);

/// The words that this form takes in the place of parameter `position`, a word itself, with all
/// other parameters as they are. The word that stands there is among them.
[[nodiscard]] std::vector<Word> wordsInPlace(FormId form,
                                             std::span<const Symbol> parameters,
                                             std::size_t position);

}  // namespace arelem::define
