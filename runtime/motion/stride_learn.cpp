#include <cmath>

#include "runtime/motion/chord.h"
#include "runtime/motion/stride.h"

namespace arelem::motion {

/// Slopes of a gap at both ends of a cut vector.
std::array<double, 2> Stride::slopes(std::size_t role,
                                     const PathPoint& a,
                                     const PathPoint& b,
                                     double length) const {
  if (path_.middle.straight && path_.middle.end == b.toolEnd && !path_.guides[role].field->flat()) {
    return path_.middle.ends[role];
  }
  const Vec3 turn = a.axis != b.axis ? spin(a.axis, b.axis, length) : Vec3(Vec3::Zero());
  const Vec3 direction = (b.toolEnd - a.toolEnd) / length;
  return {slopeAlong(a.contacts[role], a.toolEnd, direction, turn),
          slopeAlong(b.contacts[role], b.toolEnd, direction, turn)};
}

/// Takes the curvature of a chord at its start, and how it changes, from both halves, which have
/// those of their middles; false where it is straight.
bool Stride::learnCurvature(std::size_t role, const PathPoint& a, const PathPoint& b) {
  Guide& g = path_.guides[role];
  const double length = g.flat() ? 0.0 : (b.toolEnd - a.toolEnd).norm();
  if (length <= 0.0) {
    return false;
  }
  const auto [before, behind] = slopes(role, a, b, length);
  g.bend = meanCurvature(before, behind, length);
  g.trend = g.spread = 0.0;
  g.aim = 0;
  if (path_.middle.end == b.toolEnd && path_.middle.smooth[role] && g.bend != 0.0) {
    const double change = 2.0 * (behind + before - 2.0 * path_.middle.slope[role]) / length;
    g.trend = 2.0 * change / length;
    g.spread = length;
    g.bend -= 0.5 * length * g.trend;
  }
  return true;
}

/// Takes over the curvatures of a trial chord; true where the sign of one differs from what it was
/// taken for. Those of facets tell nothing.
bool Stride::learnTurn(const PathPoint& a, const PathPoint& b) {
  bool turns = false;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    const double before = g.bend;
    if (!g.field->isFaceted() && learnCurvature(i, a, b)) {
      g.error = 0.0;
      const double behind = g.bend + g.spread * g.trend;
      turns = turns || (g.bend >= 0.0) != (before >= 0.0) || (behind >= 0.0) != (before >= 0.0);
    }
  }
  return turns;
}

/// Aims at the edge of the band from which the trial chord swerves least; true where that is not
/// the one it did.
bool Stride::learnSwerve() {
  bool turns = false;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    const auto& swerve = path_.swerves[i];
    if (swerve && *swerve != 0.0 && g.aim == 0 && (g.bend >= 0.0) != (*swerve >= 0.0)) {
      g.startAnew(*swerve);
      turns = true;
    }
  }
  return turns;
}

void Stride::learn(const PathPoint& a, const PathPoint& b) {
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    Guide& g = path_.guides[i];
    if (g.field->isFaceted() || !learnCurvature(i, a, b)) {
      continue;
    }
    if (path_.middle.end == b.toolEnd && !path_.middle.smooth[i] && path_.middle.behind[i]) {
      g.startAnew(*path_.middle.behind[i]);
    } else {
      g.bend += g.spread * g.trend;
    }
  }
}

}  // namespace arelem::motion
