#pragma once
#include <string>

#include "runtime/stencil/alphabet.h"

namespace arelem::stencil {

/// Why a fan that goes along these lines, from one to the next, would not paint what lies between
/// them: two lines with no area between them, lines that cross, or a way that turns back over what
/// is painted. Empty: nothing is wrong. Lengths in units of the grid.
[[nodiscard]] std::string objectionToLines(const std::vector<Line>& lines);

/// Why the stroke cannot go on from the one before with the gun open: between the last line of that
/// and its own first there is a gap wider than the fan, the fan would turn round, or a straight
/// stroke would turn back over the one before. Empty: nothing is wrong.
[[nodiscard]] std::string objectionToJoin(const Stroke& before,
                                          const Stroke& stroke,
                                          double symbolWidth,
                                          double gridHeight);

}  // namespace arelem::stencil
