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
  std::string notDrawn;  ///< "2 QADRIC, 1 RLDSRF", or ""
};

/// Draws the legend with a scale bar into the box, in one column or, in a low box, in several.
void drawLegend(Canvas& canvas, const Box& box, const Shown& shown);

/// Four significant digits without trailing zeros; from 10 000 on all digits before the point.
[[nodiscard]] std::string shortNumber(double value);

}  // namespace arelem::backend::svg
