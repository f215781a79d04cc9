#pragma once
#include "ir/space/vector.h"

/// Private to runtime/tool.
namespace arelem::tool {

/// How the contact turns about the axis as the tool goes on from `te`, and how that changes on the
/// way.
template <class Search>
void noteTurns(Search& search, const Vec3& te, const Vec3& turns, const Vec3& before) {
  constexpr double leastWay = 1e-12;
  const Vec3 way = te - search.towardAt;
  const double squared = way.squaredNorm();
  if (squared > leastWay * leastWay) {
    search.turnsAlong = way;
    search.turnsChange =
        before.isZero(0.0) ? Vec3(Vec3::Zero()) : Vec3(1.0 / squared * (turns - before));
  }
  search.towardAt = te;
  search.towardTurns = turns;
}

}  // namespace arelem::tool
