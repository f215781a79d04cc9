#pragma once
#include "runtime/stencil/alphabet.h"

namespace arelem::stencil {

/// How the two edges of a curved stroke are divided.
enum class Division {
  equal,    ///< into parts of equal length
  asSource  ///< as the source's program: parameters interpolated linearly over as many chords as
            ///< there are cells, the straight part counted from its end. Reproduces its numbers.
};

/// One edge as cells + 1 points. Division::asSource knows the edges of the source, a spline or arc
/// with at most one line behind it; others, and circles, are divided into equal lengths by both.
[[nodiscard]] std::vector<Vec2> divideEdge(const Edge& edge, int cells, Division division);

/// The fan lines of a shape as it stands in the file, in units of the grid. `cells`: of a curved
/// shape, of each part of a straight one.
[[nodiscard]] std::vector<Line> linesOf(const Shape& shape, int cells, Division division);
/// The lines of a stroke's shape in the order they are painted, at its place in a symbol of this
/// width.
[[nodiscard]] std::vector<Line> placedLines(const Stroke& stroke,
                                            std::vector<Line> lines,
                                            double symbolWidth,
                                            double gridHeight);
/// Both.
[[nodiscard]] std::vector<Line> linesOf(
    const Stroke& stroke, double symbolWidth, double gridHeight, int cells, Division division);

}  // namespace arelem::stencil
