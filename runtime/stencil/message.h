#pragma once
#include <string_view>

#include "ir/limits.h"
#include "runtime/stencil/divide.h"

namespace arelem::stencil {

/// How a text stands on the ground; lengths in the unit of the part.
struct Placement {
  Vec2 origin = Vec2::Zero();   ///< lower left corner of the first symbol
  double height = 0.0;          ///< of the symbols
  double angle = 0.0;           ///< of the line of writing, degrees from x
  std::optional<double> space;  ///< between two symbols; none: the alphabet's
};

/// Fan lines that are painted without closing the gun. Lengths in the unit of the part.
struct Run {
  std::string symbol;
  std::size_t position = 0;  ///< of the symbol in the text, from 0
  std::size_t stroke = 0;    ///< number of its first stroke in the symbol, from 1
  std::vector<Line> lines;
  bool backwards = false;  ///< against the direction of the alphabet
};

struct Writing {
  Division division = Division::equal;
  int cells = 0;         ///< of a curved primitive; 0: as the alphabet says
  bool leaning = false;  ///< with the lines of each run moved for the evenest film
};

/// The symbols of a text in order: characters, and names in angle brackets. A blank is "".
/// Error: E0560 names the first character that the alphabet does not have, and those it has.
[[nodiscard]] Result<std::vector<const Symbol*>> symbolsOf(std::string_view text,
                                                           const Alphabet& alphabet);

/// Lays out the text and divides its strokes. Strokes that join are one run; where the division is
/// the source's, a joining stroke leaves out its first line as the source does, else only where the
/// line is painted already.
[[nodiscard]] Result<std::vector<Run>> runsOf(std::string_view text,
                                              const Alphabet& alphabet,
                                              const Placement& placement,
                                              const Writing& writing,
                                              const Limits& limits);

/// Puts the runs in an order, some of them backwards, in which the gun travels less between them
/// from `start`: nearest next, then exchanges until none helps. Never longer than the given order.
void shorten(std::vector<Run>& runs, const Vec2& start);
/// The way from `start` and from the end of each run to the beginning of the next.
[[nodiscard]] double travelOf(const std::vector<Run>& runs, const Vec2& start);

}  // namespace arelem::stencil
