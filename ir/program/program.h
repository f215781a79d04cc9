#pragma once
#include <iosfwd>
#include <string>
#include <vector>

#include "ir/program/feature.h"
#include "ir/program/statement.h"

namespace arelem::ir {

/// A name of the program. Its first assignment in the text fixes its class.
struct Symbol {
  enum class Kind : std::uint8_t { scalar, entity };
  std::string name;
  Kind kind = Kind::scalar;
  EntityType type = EntityType::point;  ///< when kind is entity
  std::uint32_t arraySize = 0;          ///< RESERV size, 0 when not an array
  Span definition;
};

/// The main program (block 0) or one macro body with its parameters substituted.
struct Block {
  std::string name;  ///< "" for the main program
  std::vector<Statement> statements;
};

/// A parsed and checked part program: what frontend, runtime and REPL share.
struct Program {
  std::vector<Symbol> symbols;
  std::vector<Expr> exprs;
  std::vector<Definition> definitions;
  std::vector<Block> blocks;
  /// Counts of what the frontend accepted and the tables above do not show.
  FeatureCounts features;
  std::string_view dialect;  ///< the one in which the text was read

  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols[id.index]; }
  [[nodiscard]] const Expr& operator[](ExprId id) const { return exprs[id.index]; }
  [[nodiscard]] const Definition& operator[](DefinitionId id) const {
    return definitions[id.index];
  }
  [[nodiscard]] const Block& operator[](BlockId id) const { return blocks[id.index]; }
};

/// The stable text of a program (`--to ir`): one statement a line, numbers in shortest round-trip
/// form.
void print(std::ostream& out, const Program& program);

}  // namespace arelem::ir
