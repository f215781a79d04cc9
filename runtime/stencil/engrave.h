#pragma once
#include "ir/limits.h"
#include "runtime/files/files.h"
#include "runtime/stencil/message.h"

namespace arelem::stencil {

/// An ENGRAV statement with all values, in the unit of the part program.
struct Engraving {
  std::string text;
  Placement placement;  ///< its height is that of the pen grid
  double width = 0.0;   ///< of the pen grid; 0: in proportion to the height
  double chord = 0.0;   ///< largest departure of the chords from the curves
  std::string alphabet = "roadway.alphabet";
};

/// A line that is cut without lifting the tool.
struct PenLine {
  std::string symbol;
  std::vector<Vec2> points;
  [[nodiscard]] bool isClosed() const;
};

/// The pen lines of a text, laid out, chorded and put in an order, some of them backwards, that
/// shortens the way between them from `start`. Errors: those of the alphabet file, E0560, E0563,
/// E0564.
[[nodiscard]] Result<std::vector<PenLine>> penLines(const Engraving& engraving,
                                                    const files::Files& files,
                                                    const Limits& limits,
                                                    const Vec2& start);
/// The same with an alphabet that was read already.
[[nodiscard]] Result<std::vector<PenLine>> penLines(const Engraving& engraving,
                                                    const Alphabet& alphabet,
                                                    const Limits& limits,
                                                    const Vec2& start);

}  // namespace arelem::stencil
