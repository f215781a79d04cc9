#include "runtime/motion/stride.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Interior cut vectors end within this share of the band of the gap aimed at.
constexpr double aimShare = 1e-5;
/// A chord is taken when it could grow by less than this factor.
constexpr double goodFit = 1.01;
constexpr double safety = 0.9995;
constexpr int tryLimit = 40;
constexpr int growLimit = 4;
/// A slope that changes by less over a cut vector does not change: a plane seen by a tool that
/// turns.
constexpr double levelChange = 1e-11;
/// Largest turn of the path over one cut vector, as a cosine.
constexpr double turnCosine = 0.2;
}  // namespace

/// Longest chord that the bands allow by the present curvature.
double Stride::planned(const PathPoint& a) const {
  double length = path_.flat() ? tolerance::farAway : longest_;
  for (std::size_t i = 0; i < path_.guides.size(); ++i) {
    const Guide& g = path_.guides[i];
    const double from = a.contacts[i].gap;
    length = std::min(length, longestChord(g.bend, from, g.vertexGap(), std::max(g.inner, -from),
                                           std::max(g.outer, from)));
  }
  return length;
}

std::optional<PathPoint> Stride::next(const PathPoint& a, double cap) {
  double length = std::min(planned(a), cap);
  double accept = tolerance::farAway;
  for (const Guide& g : path_.guides) {
    accept = std::min(accept, aimShare * (g.inner + g.outer));
  }
  std::optional<PathPoint> best;
  double bestLength = 0.0;
  for (int i = 0; i < tryLimit && length > tolerance::sameSide; ++i) {
    auto b = path_.step(a, length, path_.vertexGaps(), accept);
    if (!b || b->tangent.dot(a.tangent) < turnCosine) {
      length *= 0.5;
      continue;
    }
    const double factor = path_.fitWithTurn(a, *b);
    if (factor < 1.0 - tolerance::coincidence) {
      // Past an inflection the surface bends the other way than it did: aim at the other edge of
      // the band before shortening the chord.
      if (i == 0 && learnTurn(a, *b)) {
        length = std::min({planned(a), cap, length});
      } else {
        length *= std::max(factor * safety, 0.3);
      }
      continue;
    }
    const double reached = (b->toolEnd - a.toolEnd).norm();
    const bool better = !best || reached > bestLength;
    if (better) {
      best = std::move(b);
      bestLength = reached;
    }
    if (!better || factor < goodFit || length >= cap * safety || length >= longest_ ||
        i > growLimit) {
      break;
    }
    length = std::min({length * std::min(factor * safety, 2.0), cap, longest_});
  }
  return best;
}

/// Takes over the curvatures of a trial chord where their sign differs; true where one does.
bool Stride::learnTurn(const PathPoint& a, const PathPoint& b) {
  auto& guides = path_.guides;
  const std::array before{guides[0].bend >= 0.0, guides[1].bend >= 0.0};
  learn(a, b);
  return (guides[0].bend >= 0.0) != before[0] || (guides[1].bend >= 0.0) != before[1];
}

void Stride::learn(const PathPoint& a, const PathPoint& b) {
  const Vec3 chord = b.toolEnd - a.toolEnd;
  const double squared = chord.squaredNorm();
  const double length = std::sqrt(squared);
  const Vec3 turn = a.axis != b.axis ? spin(a.axis, b.axis, length) : Vec3(Vec3::Zero());
  for (std::size_t i = 0; i < path_.guides.size() && squared > 0.0; ++i) {
    Guide& g = path_.guides[i];
    if (!g.flat()) {
      const Vec3 direction = chord / length;
      const double change = slopeAlong(b.contacts[i], b.toolEnd, direction, turn) -
                            slopeAlong(a.contacts[i], a.toolEnd, direction, turn);
      g.bend = std::abs(change) <= levelChange ? 0.0 : change / length;
    }
  }
}

}  // namespace arelem::motion
