#pragma once
#include "ir/text/span.h"
#include "runtime/files/files.h"
#include "runtime/stencil/plan.h"

namespace arelem::stencil {

/// A STENCL statement with all values, in mm.
struct Statement {
  std::string text;
  Placement placement;
  double ground = 0.0;  ///< height of the ground
  Job job;
  /// Over a line one unit of the grid wide, mm/s. 0: by the film where that is stated, else as fast
  /// as the gun's largest speed allows.
  double speed = 0.0;
  double film = 0.0;  ///< wanted, mm; 0: not stated
  int output = 1;     ///< that opens the gun
  int cells = 0;      ///< NUMPTS: of a curved primitive; 0: the alphabet's
  std::string alphabet = "roadway.alphabet";
};

/// What a statement amounts to.
struct Painted {
  Statement statement;  ///< with the speed that is used
  Span origin;
  /// The origin of REFSYS and its first two directions in the base system, part unit.
  Vec3 base = Vec3::Zero(), across = Vec3::UnitX(), along = Vec3::UnitY();
  std::vector<Track> tracks;
  double given = 0.0;     ///< way without spraying in the order of the alphabet, mm
  double traveled = 0.0;  ///< in the order that is used
  /// Mean film, mm; 0 where the gun's flow is not stated.
  [[nodiscard]] double meanFilm() const;
};

/// Reads the alphabet, lays out the text, orders and plans its runs. `start` is where the gun
/// stands. Errors: those of the alphabet file, E0560 to E0564.
[[nodiscard]] Result<Painted> paint(const Statement& statement,
                                    const files::Files& files,
                                    const Limits& limits,
                                    const Vec2& start);
/// The same with an alphabet that was read already.
[[nodiscard]] Result<Painted> paint(const Statement& statement,
                                    const Alphabet& alphabet,
                                    const Limits& limits,
                                    const Vec2& start);

}  // namespace arelem::stencil
