#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/certify/motion_check.h"

/// From which side a path comes to the check surface where it ends.
namespace arelem::certify {

namespace {
/// How far ahead the slope of a gap tells how it bends, as a share of the root of its band: a touch
/// passes through the band in a length of that order.
constexpr double aheadShare = 0.05;
}  // namespace

double MotionCheck::excess(const Touch& t, const Allowed& a) {
  return std::max({0.0, -a.inner - a.slack - t.low, t.high - a.outer - a.slack});
}

/// Whether a gap that is within its band where the path ends turns round within it: a touch, which
/// is TO and PAST at one place. How the gap bends follows from its slopes along the last cut
/// vector, along the path at its end and a little ahead. It does where both lead back (`leaves`).
bool MotionCheck::isTouch(const Modal& modal,
                          const surface::AnySurface& drive,
                          const PathEnd& at,
                          const surface::AnySurface& check,
                          const Relation& relation,
                          const Allowed& allowed,
                          const Touch& t,
                          bool leaves) const {
  if (excess(t, allowed) > 0.0) {
    return false;
  }
  const Touch across = touchOf(modal, drive, driveRole, at.place());
  const Touch up = touchOf(modal, modal.partSurface().surface, partRole, at.place());
  const Vec3 way = at.towards(t.offset, across, up);
  const double slope = t.normal.dot(way);
  if (std::abs(slope) <= glancing || (leaves && slope > 0.0)) {
    return true;
  }
  const double step = aheadShare * std::sqrt(allowed.inner + allowed.outer);
  const Location ahead = at.ahead(step, across, up);
  const double next = touch(check, relation, ahead, allowed).normal.dot(way);
  const double bend =
      (next - slope) / step + 2.0 * (slope - t.normal.dot(at.towards(t.offset))) / at.length();
  const double rest = 0.5 * slope * slope / bend;  // from here to where it turns
  return bend > 0.0 ? t.low - rest >= -allowed.inner - allowed.slack
                    : bend < 0.0 && t.high - rest <= allowed.outer + allowed.slack;
}

/// The direction at the end does not tell this where the path turns sharply or glances along the
/// surface, or seems to tell the contrary. TO is met from the clear, PAST from the violation: the
/// gap was there when it last was out of its band, and no cut vector since left it to the other
/// side.
bool MotionCheck::cameFrom(const PathEnd& at,
                           const surface::AnySurface& check,
                           const Relation& relation,
                           ir::Condition condition,
                           const Allowed& allowed,
                           const Touch& t) {
  if (excess(t, allowed) > 0.0) {
    return false;
  }
  const bool clear = condition == ir::Condition::to;
  Allowed since{allowed.inner, tolerance::farAway, allowed.slack, false};
  Allowed before{-allowed.outer, tolerance::farAway, -allowed.slack, false};
  if (!clear) {
    since = {tolerance::farAway, allowed.outer, allowed.slack, false};
    before = {tolerance::farAway, -allowed.inner, -allowed.slack, false};
  }
  const auto probe = makeProbe(check, relation);
  const std::vector<Location>& path = at.recent();
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    const Location& a = path[i - 1];
    const Location& b = path[i];
    probe->take(Chord(a.toolEnd, b.toolEnd, a.axis, b.axis));
    Node first = probe->at(0.0);
    if (!prove(*probe, since, first).good()) {
      return false;
    }
    if (excess(touch(check, relation, a, before), before) == 0.0) {
      return true;
    }
  }
  return false;
}

/// Whether the gap was on the other side of what it is at the end just before, on the last cut
/// vector: a tool that came from there all the same has turned round within the band, where TO and
/// PAST are at one place.
bool MotionCheck::hasTurned(const PathEnd& at,
                            const surface::AnySurface& check,
                            const Relation& relation,
                            ir::Condition condition,
                            const Allowed& allowed,
                            const Touch& t) {
  const std::vector<Location>& path = at.recent();
  if (excess(t, allowed) > 0.0 || path.size() < 2) {
    return false;
  }
  const Location& from = path[path.size() - 2];
  const Vec3 back = from.toolEnd - at.place().toolEnd;
  const double step = aheadShare * std::sqrt(allowed.inner + allowed.outer);
  if (from.axis != at.place().axis || back.norm() < step) {
    return false;
  }
  Location before = at.place();
  before.toolEnd += step / back.norm() * back;
  const Touch then = touch(check, relation, before, allowed);
  return excess(then, allowed) == 0.0 &&
         (condition == ir::Condition::to ? then.low > t.high + allowed.slack
                                         : then.high < t.low - allowed.slack);
}

}  // namespace arelem::certify
