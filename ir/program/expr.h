#pragma once
#include <string>
#include <variant>
#include <vector>

#include "ir/geometry/entity.h"
#include "ir/program/id.h"
#include "ir/words/words.h"

namespace arelem::ir {

/// A name as it is used or assigned: a symbol, with a subscript where the symbol is an array.
struct Target {
  SymbolId symbol;
  ExprId subscript;  ///< none unless subscripted
  Span span;
  auto operator<=>(const Target&) const = default;
};

/// name(a,THRU,b,INCR,c) and its short forms: several elements of an array.
struct ElementRange {
  SymbolId symbol;
  ExprId low;               ///< none: 1
  ExprId high;              ///< none: the last element (ALL)
  ExprId step;              ///< none: 1
  bool descending = false;  ///< DECR
  Span span;
};

/// An empty parameter between two commas.
struct Omitted {};

/// One parameter of a statement, a definition or a function.
struct Argument {
  using Value = std::variant<Omitted,
                             ExprId,        // a scalar
                             Word,          // a vocabulary word
                             Target,        // an entity symbol (scalar symbols are ExprIds)
                             ElementRange,  // entities or scalars of an array
                             DefinitionId,  // a nested definition
                             std::string>;  // text: an unknown word of a post statement, a string
  Value value;
  Span span;
};

/// A scalar expression. Nodes live in Program::exprs; `left` and `right` are none where unused.
struct Expr {
  enum class Kind : std::uint8_t {
    number,  // number
    symbol,  // target (a scalar symbol or array element)
    assign,  // (A = left): a nested scalar definition, stored in target
    negate,  // left
    add,
    subtract,
    multiply,
    divide,
    power,  // left, right
    call    // function(arguments)
  };
  Kind kind = Kind::number;
  Span span;
  double number = 0.0;
  ExprId left;
  ExprId right;
  Target target;
  Word function = Word::ABSF;
  std::vector<Argument> arguments;
};

/// TYPE/ parameters, at the head of a statement or nested in another one.
struct Definition {
  EntityType type = EntityType::point;
  Span typeSpan;
  Target target;  ///< target.symbol none when the definition is unnamed
  std::vector<Argument> arguments;
  Span span;
};

}  // namespace arelem::ir
