#include "runtime/motion/meet.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/motion/settle.h"
#include "runtime/motion/zero.h"

namespace arelem::motion {

namespace {
/// A position found by Newton may lie this many bands from the bracket, over the sine of the angle
/// at which the path meets the check surface.
constexpr double bandsAside = 4.0;
constexpr double leastSine = 0.02;

/// Newton on all three gaps.
std::optional<PathPoint> settleThere(Path& path,
                                     const PathPoint& guess,
                                     const CheckWatch& watch,
                                     const CheckWatch::Hit& hit,
                                     double checkRest) {
  const auto rests = path.rests();
  const std::array wanted{Wanted{path.guides[0].field.get(), rests[0]},
                          Wanted{path.guides[1].field.get(), rests[1]},
                          Wanted{hit.field, checkRest}};
  const Settled settled = settle(guess.toolEnd, path.axis, wanted, {});
  if (!settled.ok) {
    return std::nullopt;
  }
  double bands = watch.band();
  for (const Guide& g : path.guides) {
    bands += g.inner + g.outer;
  }
  const PathPoint there = path.look(settled.toolEnd, guess.tangent);
  const double sine = std::max(std::abs(settled.contacts[2].normal.dot(there.tangent)), leastSine);
  const double reach = hit.high - hit.low + bandsAside * bands / sine;
  return (settled.toolEnd - guess.toolEnd).norm() <= reach ? std::optional(there) : std::nullopt;
}

/// What changes its sign at the stop: the gap itself, or at a touch its slope less that at the
/// touch.
double signal(Path& path, const PathPoint& p, const CheckWatch::Hit& hit, double checkRest) {
  const tool::Contact c = hit.field->at(p.toolEnd, p.axis);
  return hit.touch ? slopeAlong(c, p.toolEnd, p.tangent, path.spinAt(p)) - hit.level
                   : c.gap - checkRest;
}
/// The way that is left from where the slope is that of the hit to where it is 0, by the change of
/// the slope up to there: behind it may be a stretch of no slope.
template <class Measure>
double toLevel(const Measure& measure, const CheckWatch::Hit& hit, double s) {
  if (!hit.touch || hit.level == 0.0) {
    return 0.0;
  }
  constexpr double back = tolerance::coincidence;
  const auto before = measure(s - back);
  const double rate = before ? -*before / back : 0.0;
  const double way = rate != 0.0 ? -hit.level / rate : 0.0;
  return way >= 0.0 && way <= back ? way : 0.0;
}
}  // namespace

std::optional<PathPoint> meet(Path& path,
                              const PathPoint& from,
                              const Segment& segment,
                              const CheckWatch& watch,
                              const CheckWatch::Hit& hit,
                              double checkRest) {
  const auto onArc = [&](double s) -> std::optional<PathPoint> {
    return path.look(segment.at(s), segment.tangentAt(s));
  };
  const auto onPath = [&](double s) -> std::optional<PathPoint> {
    PathPoint there;
    const double along = s * segment.direction.dot(from.tangent);
    return path.step(from, along, path.rests(), 0.0, there) ? std::optional(there) : std::nullopt;
  };
  const auto search = [&](auto place, const CheckWatch::Hit& sought) {
    const auto measure = [&](double s) -> std::optional<double> {
      const auto p = place(s);
      return p ? std::optional(signal(path, *p, sought, checkRest)) : std::nullopt;
    };
    const auto s = zeroBetween(measure, hit.low, hit.high);
    return s ? place(*s + toLevel(measure, sought, *s)) : std::nullopt;
  };
  CheckWatch::Hit touch = hit;
  touch.touch = true;
  if (segment.isArc()) {
    auto found = search(onArc, hit);
    const auto exact =
        found && !hit.touch ? settleThere(path, *found, watch, hit, checkRest) : std::nullopt;
    return exact ? exact : found ? found : search(onArc, touch);
  }
  if (!hit.touch) {
    const PathPoint guess = path.look(segment.at(0.5 * (hit.low + hit.high)), from.tangent);
    if (auto exact = settleThere(path, guess, watch, hit, checkRest)) {
      return exact;
    }
  }
  // Where the chord crosses what the path only touches, the slope changes its sign.
  auto found = search(onPath, hit);
  found = found ? found : search(onPath, touch);
  if (found || hit.low >= 0.0) {
    return found;
  }
  // Where cut vectors join, a step along the path is shorter than it is wide; before the join the
  // chord is not in the bands.
  found = search(onArc, touch);
  return found ? path.standing(found->toolEnd, found->tangent, path.rests(), nullptr) : found;
}

}  // namespace arelem::motion
