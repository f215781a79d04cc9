#include "runtime/motion/corners.h"

#include "ir/space/tolerance.h"
#include "runtime/motion/axis_turn.h"

namespace arelem::motion {

namespace {
/// Corners of a path are farther apart than this: where they are not, the contact flutters. A
/// share of the band.
constexpr double cornersApart = 0.01;

/// Cut vectors that end before a corner by more than this have one more up to it. Part unit.
constexpr double cornerMissed = 1e-7;

/// How far ahead of where a path ends its other axis is looked for, in bands.
constexpr double aheadBands = 10.0;

/// Over a crossing of paths: the shortest cut vector that is tried, in bands, and the largest turn,
/// as a cosine.
constexpr double shortestAcross = 0.01;
constexpr double straight = 0.87;

bool isAt(const std::optional<Vec3>& corner, const PathPoint& place, double band) {
  return corner && (*corner - place.toolEnd).norm() <= cornersApart * band;
}
}  // namespace

std::optional<Corners::Way> Corners::from(const PathPoint& last, const PathPoint* tip) {
  auto way = turned(last, tip);
  way = way ? way : leapt(last);
  if (way) {
    startAnew();
  }
  return way;
}

/// The last cut vector may have ended before the corner, and from there the next one would leave
/// the band: the tip is gone to.
std::optional<Corners::Way> Corners::turned(const PathPoint& last, const PathPoint* tip) {
  const PathPoint& at = tip != nullptr ? *tip : last;
  const auto round = isAt(turn_, at, path_.band()) ? std::nullopt : path_.roundCorner(at);
  if (!round) {
    return std::nullopt;
  }
  turn_ = at.toolEnd;
  const bool apart = (at.toolEnd - last.toolEnd).norm() > cornerMissed;
  return Way{apart ? std::vector<PathPoint>{at} : std::vector<PathPoint>{}, *round};
}

std::optional<PathPoint> Corners::straightOn(const PathPoint& last,
                                             const Vec3& way,
                                             const std::array<double, 2>& gaps) {
  const double length = way.norm();
  const Vec3 direction = way / length;
  auto p = path_.standing(last.toolEnd + way, direction, gaps, nullptr);
  const bool fits = p && length >= straight * (p->toolEnd - last.toolEnd).norm() &&
                    p->tangent.dot(direction) >= straight && path_.fitWithTurn(last, *p) >= 1.0;
  return fits ? p : std::nullopt;
}

/// Twice as far each time: far behind the crossing both surfaces guide the tool again.
std::optional<PathPoint> Corners::across(const PathPoint& last,
                                         const Vec3& direction,
                                         double longest) {
  const std::array choices{std::array{last.contacts[0].gap, last.contacts[1].gap}, path_.rests(),
                           path_.vertexGaps()};
  std::optional<PathPoint> best;
  double bestLength = 0.0;
  for (const auto& gaps : choices) {
    for (double length = shortestAcross * path_.band(); length <= longest; length *= 2.0) {
      auto p = length > bestLength ? straightOn(last, length * direction, gaps) : std::nullopt;
      if (p) {
        best = std::move(p);
        bestLength = length;
      }
    }
  }
  if (best) {
    startAnew();
  }
  return best;
}

/// One place of the cutter gives an axis with which another touches, and that one an axis with
/// which it goes on touching: no axes between them hold the rule, and the tool turns where it is.
std::optional<Corners::Way> Corners::leapt(const PathPoint& last) {
  if (path_.axis.isFixed() || isAt(leap_, last, path_.band())) {
    return std::nullopt;
  }
  leap_ = last.toolEnd;
  // The other axis is that with which the tool would go on.
  const Vec3 ahead = last.toolEnd + aheadBands * path_.band() * last.tangent;
  const Vec3 beyond = path_.axis.at(ahead);
  path_.axis.stand(ahead, beyond);
  std::vector<PathPoint> ends = turnOntoPath(path_, last, last.tangent);
  if (ends.empty() || (ends.back().axis - last.axis).norm() <= tolerance::nullDirection) {
    return std::nullopt;
  }
  const PathPoint on = ends.back();
  return Way{std::move(ends), on};
}

/// Nothing is known of the path behind the corner.
void Corners::startAnew() {
  for (Guide& g : path_.guides) {
    g.startAnew(0.0);
  }
}

}  // namespace arelem::motion
