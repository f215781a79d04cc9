#pragma once
#include <string_view>

#include "ir/program/statement.h"

namespace arelem::frontend {

/// The fast lane of CL files: lines `GOTO/ x,y[,z[,i,j,k][,f]]`, FROM/ and GODLTA/ dx,dy,dz with
/// plain numbers are read without tokens or trees. It leaves a line to the parser on anything
/// unusual: label, symbol, blank inside a number, exponent without a decimal point, or a count of
/// numbers that the word does not have.
enum class FastLane : std::uint8_t {
  none,   ///< left to the parser
  whole,  ///< a statement
  open    ///< it ends in `$`: the next line is to be appended
};

/// A statement of the fast lane.
struct FastLine {
  std::size_t begin = 0;  ///< of the statement within its first line
  std::size_t end = 0;    ///< behind it, within its last line
  bool comment = false;   ///< `$$` stands behind it
  ir::LocateNumbers numbers;
  bool wantsNumber = false;  ///< an open one ends in a slash or comma
};

/// Reads the first line of a statement.
[[nodiscard]] FastLane readFastLine(std::string_view line, FastLine& result);
/// Reads a line behind one that was `open`.
[[nodiscard]] FastLane appendFastLine(std::string_view line, FastLine& result);

}  // namespace arelem::frontend
