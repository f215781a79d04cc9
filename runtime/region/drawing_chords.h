#pragma once
#include <functional>
#include <vector>

#include "runtime/region/drawing.h"

namespace arelem::region {

/// Appends f over (from, to] so finely that the points' chords stay within `chord` of the curve.
/// Beyond `mostPoints` it ends early.
void addChords(const std::function<Vec2(double)>& f,
               double from,
               double to,
               double chord,
               std::size_t mostPoints,
               std::vector<Vec2>& points);

}  // namespace arelem::region
