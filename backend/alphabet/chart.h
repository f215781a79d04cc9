#pragma once
#include <array>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

/// A picture of the symbols of an alphabet: pure output, so the lines of the fan come as they are.
namespace arelem::backend {

using ChartPoint = std::pair<double, double>;

/// In units of the grid, y up from the foot.
struct ChartSymbol {
  std::string name;
  double width = 4.0;
  /// The fan lines of each stroke, from the first to the second edge.
  std::vector<std::vector<std::array<ChartPoint, 2>>> strokes;
  std::vector<std::vector<ChartPoint>> pens;  ///< lines of no width, drawn instead
};

struct Chart {
  std::string title;
  double height = 25.0;  ///< of all symbols
  double unit = 14.0;    ///< pixels of one grid unit
  std::vector<ChartSymbol> symbols;
  bool lines = true;  ///< with the fan lines and the grid; else as on the road
};

/// All symbols side by side in rows, SVG.
void writeChart(std::ostream& out, const Chart& chart);

}  // namespace arelem::backend
