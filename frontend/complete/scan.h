#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "frontend/complete/complete.h"
#include "frontend/lex/token.h"
#include "ir/define/pattern.h"

namespace arelem::frontend {

/// What is being written at the end of an unfinished statement.
struct Place {
  enum class Kind : std::uint8_t {
    head,        ///< a statement begins
    motion,      ///< behind `TLRGT,` and the like: what may share its statement
    value,       ///< right side of `=`
    parameter,   ///< of `word` (a noun or a statement), behind `given`
    expression,  ///< a scalar
    functionArgument,
    subscript,  ///< of an array, behind `given`
    label,      ///< a jump's target
    macroName,
    nothing  ///< a name of the program's own choice
  };
  Kind kind = Kind::head;
  Word word = Word::END;
  bool definition = false;  ///< `word` is a noun
  std::vector<define::Symbol> given;
};

/// `tokens` without their end token.
[[nodiscard]] Place placeBehind(std::span<const Token> tokens, std::span<const KnownName> names);

}  // namespace arelem::frontend
