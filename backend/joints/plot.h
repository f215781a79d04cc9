#pragma once
#include <iosfwd>

#include "backend/joints/table.h"

namespace arelem::joints {

/// Curves as SVG: the path of the tool on the ground, where the gun is open drawn thick, and for
/// each joint its place, speed and acceleration over time with the limits. Figures 2.18 to 2.21 of
/// Blank (1997).
void writePlot(std::ostream& out, const Arm& arm, const Table& table);

}  // namespace arelem::joints
