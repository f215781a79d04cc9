#pragma once
#include <vector>

#include "ir/cl/record.h"
#include "ir/diag/result.h"
#include "runtime/interpret/action.h"

namespace arelem::motion {

/// An arc of a CL file with its ends known: the circle to write before each of `ends`, about which
/// the tool turns counter-clockwise. Whole turns of a helix are pieces of their own, so that the
/// sweep of each piece follows from its ends.
struct ArcMove {
  struct Piece {
    cl::Surface circle;  ///< center at the height of the start of the piece
    Vec3 end = Vec3::Zero();
  };
  std::vector<Piece> pieces;
  double length = 0.0;            ///< of the path, part unit
  Vec3 tangent = Vec3::Zero();    ///< direction of motion at the end
  std::vector<Failure> warnings;  ///< ends off the circle, a stated angle that does not fit
};

/// The arc from `start` to `end`. Both may lie off the circle by what the digits of a file take
/// away: beyond `tolerance::arcEnd` is a warning, far beyond it an error.
/// `forward` is the direction of INDIRV, which fixes the plane where the statement gives none.
[[nodiscard]] Result<ArcMove> arcMove(const runtime::Arc& arc,
                                      const Vec3& start,
                                      const Vec3& end,
                                      const std::optional<Vec3>& forward);

}  // namespace arelem::motion
