#pragma once
#include <string>
#include <string_view>

#include "backend/svg/canvas.h"

namespace arelem::backend::svg {

/// What the picture shows, for the legend.
struct Shown {
  const PathCollector& path;
  double scale = 1.0;            ///< pixels a unit
  std::size_t vertices = 0;      ///< drawn
  std::size_t toolOutlines = 0;  ///< drawn
  bool geometry = false;
  bool faults = false;
  std::string notDrawn;       ///< "2 QADRIC, 1 RLDSRF", or ""
  std::size_t namesLeft = 0;  ///< names that found no room in any view
};

/// Draws the legend with a scale bar into the box, in columns of four rows.
void drawLegend(Canvas& canvas, const Box& box, const Shown& shown);

/// Four significant digits without trailing zeros; from 10 000 on all digits before the point.
[[nodiscard]] std::string shortNumber(double value);
/// "-2 to 12.88": with as many digits as tell a hundredth of the range.
[[nodiscard]] std::string rangeText(double low, double high);

}  // namespace arelem::backend::svg
