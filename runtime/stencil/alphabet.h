#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"
#include "runtime/stencil/line.h"

namespace arelem::stencil {

/// What a stroke is drawn between: two curves that are divided alike, or a list of fan lines with
/// straight edges between them.
struct Shape {
  Edge first;
  Edge second;
  bool firstBack = false;  ///< the stroke runs along this edge from its end
  bool secondBack = false;
  std::vector<Line> lines;  ///< two or more: then there are no curves

  [[nodiscard]] bool isStraight() const { return !lines.empty(); }
};

/// How a shape stands in its symbol: mirrored in the middle of the symbol, then moved.
struct Placing {
  bool flipX = false;
  bool flipY = false;
  Vec2 move = Vec2::Zero();
};

/// A run of the gun between two edges.
struct Stroke {
  int primitive = 5;  ///< 1 bowl, 2 hook, 3 half of an S, 4 slanted or joining, 5 straight stroke
  std::shared_ptr<const Shape> shape;
  int cells = 1;  ///< of a curved shape; of each part of a straight one
  Placing placing;
  bool reverse = false;  ///< painted from its end to its beginning
  bool swap = false;     ///< first and second edge change their parts: the gun turns by 180 degrees
  bool join = false;     ///< goes on from the stroke before: the gun stays open
};

struct Symbol {
  std::string name;  ///< one character, or a name in angle brackets: "<RIGHT>"
  double width = 4.0;
  std::vector<Stroke> strokes;
  std::vector<Edge> pens;  ///< what ENGRAV cuts, on the pen grid; none: the middles of the strokes
};

/// The shapes that STENCL paints, in units of their grid: y up from the foot of the letters.
struct Alphabet {
  std::string file;
  double width = 4.0;    ///< of a space
  double height = 25.0;  ///< of all symbols: what HEIGHT of STENCL is the size of
  double spacing = 1.0;  ///< between two symbols
  /// The grid of the pen lines: single lines of natural width, which need no room for a stroke.
  double penWidth = 4.0;
  double penHeight = 6.0;
  double penSpacing = 1.5;
  std::vector<Symbol> symbols;

  [[nodiscard]] const Symbol* find(std::string_view name) const;
};

/// Reads an alphabet file; its format is in docs/manual/alphabet.md. Errors name file, line and
/// column: E0740 what stands there and what may, E0741 too many of something.
[[nodiscard]] Result<Alphabet> readAlphabet(std::string_view text, std::string_view file);

/// What a shape becomes at its place in a symbol of this width.
[[nodiscard]] Vec2 placed(const Placing& placing, double width, double height, const Vec2& point);

}  // namespace arelem::stencil
