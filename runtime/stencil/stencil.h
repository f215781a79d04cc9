#pragma once
#include "runtime/files/files.h"
#include "runtime/stencil/plan.h"

namespace arelem::stencil {

/// A STENCL statement with all values, in mm.
struct Statement {
  std::string text;
  Placement placement;
  double ground = 0.0;  ///< height of the ground
  Job job;
  double speed = 0.0;   ///< over a line one unit of the grid wide, mm/s
  int output = 1;       ///< that opens the gun
  int cells = 0;               ///< NUMPTS: of a curved primitive; 0: the alphabet's
  std::string alphabet = "roadway.alphabet";
};

/// What a statement amounts to.
struct Painted {
  std::vector<Track> tracks;
  double given = 0.0;     ///< way without spraying in the order of the alphabet, mm
  double traveled = 0.0;  ///< in the order that is used
};

/// Reads the alphabet, lays out the text, orders and plans its runs. `start` is where the gun
/// stands. Errors: those of the alphabet file, E0560 to E0564.
[[nodiscard]] Result<Painted> paint(const Statement& statement,
                                    const files::Files& files,
                                    const Limits& limits,
                                    const Vec2& start);

}  // namespace arelem::stencil
