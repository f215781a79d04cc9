#pragma once
#include "app/cl_moves.h"

namespace arelem::app {

/// How far a run of straight moves may leave an arc.
struct ChordAllowed {
  double ends = 0.0;    ///< at its last end, and of its ends along the path
  double chords = 0.0;  ///< of all places of the moves
};

/// Straight moves that stand for an arc of another file: their ends lie on it one behind the other,
/// and with the sagitta between two of them no place is further off than allowed. The arc rises
/// evenly (a helix).
class ChordRun {
 public:
  /// `scale`: from the unit of the arc to the common one.
  ChordRun(const ClMove& arc, double scale, const ChordAllowed& allowed);
  /// Takes the next move; false where it does not keep to the arc.
  [[nodiscard]] bool take(const ClMove& line, double scale);
  /// Whether the last move ended where the arc does.
  [[nodiscard]] bool arrived() const { return arrived_; }

 private:
  /// Angle behind the start of the arc, not before `last_`.
  [[nodiscard]] double angleOf(const Vec3& place) const;

  ChordAllowed allowed_;
  Vec3 center_, end_, u_, v_, normal_;
  Vec3 axis_;
  double feed_ = 0.0;
  double radius_ = 0.0;
  double startHeight_ = 0.0, rise_ = 0.0;
  double sweep_ = 0.0;  ///< radians, above 0
  double last_ = 0.0;
  bool arrived_ = false;
};

}  // namespace arelem::app
