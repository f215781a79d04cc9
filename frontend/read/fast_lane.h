#pragma once
#include <string_view>

#include "ir/program/statement.h"

namespace arelem::frontend {

/// The fast lane of CL files: a whole line `GOTO/ x,y[,z[,i,j,k][,f]]` or FROM/ with plain numbers
/// is read without tokens or trees. Returns false, leaving the line to the parser, on anything
/// unusual: continuation, comment, label, symbol, blank inside a number, exponent without a decimal
/// point, or a count of numbers that GOTO does not have. `begin` and `end` are set to the statement
/// within the line.
struct FastLine {
  std::size_t begin = 0;
  std::size_t end = 0;
  ir::LocateNumbers numbers;
};
[[nodiscard]] bool readFastLine(std::string_view line, FastLine& result);

}  // namespace arelem::frontend
