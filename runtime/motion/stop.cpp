#include "runtime/motion/stop.h"

#include <algorithm>
#include <cmath>

#include "ir/space/motion_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/motion/meet.h"
#include "runtime/motion/route.h"

namespace arelem::motion {

namespace {
/// Sine of the largest angle between a path and the lines of a surface that it keeps along for
/// ever.
constexpr double alongLines = 1e-12;

bool keepsAlong(const surface::AnySurface& surface, const Vec3& direction) {
  if (const auto* plane = std::get_if<surface::Plane>(&surface)) {
    return std::abs(plane->normal.dot(direction)) <= alongLines;
  }
  const Vec3 lines = surface::generatrix(surface);
  return !lines.isZero() && lines.cross(direction).norm() <= alongLines;
}

/// Normals that agree this well, as a cosine, belong to surfaces that touch.
constexpr double touching = 0.5;
}  // namespace

std::optional<Met> StopFinder::scan(const Segment& segment) {
  std::optional<Met> first;
  for (std::size_t i = 0; i < course_.watches.size(); ++i) {
    CheckWatch& watch = course_.watches[i];
    Guide& partner = watch.usesPart() ? course_.partGuide() : course_.driveGuide();
    const auto hit = watch.scan(segment, *partner.field);
    if (hit && (!first || hit->low < first->hit.low)) {
      first = Met{i, *hit};
    }
  }
  return first;
}

std::optional<PathPoint> StopFinder::stop(const PathPoint& a, const Segment& segment, Met& met) {
  const Vec3 near = withoutTolerances(a, segment, met);
  if (!course_.exact) {
    const Vec3 path = course_.path.look(near, a.tangent).tangent;
    for (Guide& g : course_.path.guides) {
      g.rest = restGap(*g.field, near, course_.path.axis, g.inner, g.outer, false, path);
    }
  }
  const Role role = roleOf(met);
  met.rest = met.hit.touch ? 0.0
                           : restGap(*met.hit.field, near, course_.path.axis, state_.inner[role],
                                     state_.outer[role], course_.exact, Vec3::Zero());
  auto end = atRest(a, segment, met);
  // A chord may cross what the path proper only touches, but for a whole stretch.
  const bool tangent = course_.watches[met.check].isTangent();
  const bool strays = tangent ? end && !mayBegin(met, *end) : met.hit.touch && met.hit.level == 0.0;
  if (end && !segment.isArc() && (strays || !isContact(met, *end))) {
    end = closer(a, segment, met, *end);
  }
  return end && tangent && segment.isArc() ? onCircle(met, *end) : end;
}

/// Circle to circle the plane route ends exactly at the next one, wherever in its band the tool
/// went round the first.
PathPoint StopFinder::onCircle(const Met& met, const PathPoint& end) {
  const auto& check = course_.watches[met.check].surface().surface;
  if (!std::holds_alternative<surface::Cylinder>(check)) {
    return end;
  }
  const tool::Contact c = met.hit.field->at(end.toolEnd, end.axis);
  const Vec3 level = -c.gap * c.normal;
  const Vec3& part = end.contacts[0].normal;
  const Vec3 place = end.toolEnd + level - part.dot(level) / part.dot(end.axis) * end.axis;
  const PathPoint there = course_.path.look(place, end.tangent);
  const double gap = there.contacts[1].gap;
  const Guide& drive = course_.driveGuide();
  return gap >= -drive.inner - tolerance::sameSide && gap <= drive.outer + tolerance::sameSide
             ? there
             : end;
}

/// Where the path without tolerances stops. Cut vectors end anywhere in their bands, and the next
/// to rounding tells them apart: what is measured here is the same however the motion came.
Vec3 StopFinder::withoutTolerances(const PathPoint& a, const Segment& segment, const Met& met) {
  const Vec3 onChord = segment.at(0.5 * (met.hit.low + met.hit.high));
  if (course_.exact) {
    return onChord;
  }
  for (Guide& g : course_.path.guides) {
    g.rest = 0.5 * (g.outer - g.inner);
  }
  const auto there = meet(course_.path, a, segment, course_.watches[met.check], met.hit, 0.0);
  return there ? there->toolEnd : onChord;
}

/// A stop must be within the tolerance: a touch may be a near miss.
bool StopFinder::isContact(const Met& met, const PathPoint& end) {
  return course_.watches[met.check].touches(met.hit.field->at(end.toolEnd, end.axis).gap);
}

bool StopFinder::isWithin(const PathPoint& a, const Met& met) const {
  const Role role = roleOf(met);
  const double gap = met.hit.field->at(a.toolEnd, a.axis).gap;
  return -state_.inner[role] <= gap && gap <= state_.outer[role];
}

/// True where a motion along the check surface may begin: a tangency has one tolerance for both
/// sides, but the motion behind it has two.
bool StopFinder::mayBegin(const Met& met, const PathPoint& end) const {
  const Role role = roleOf(met);
  const double gap = met.hit.field->at(end.toolEnd, end.axis).gap;
  const double slack = tolerance::startShare * state_.band(role) + tolerance::startLength;
  return -state_.inner[role] - slack <= gap && gap <= state_.outer[role] + slack;
}

bool StopFinder::mayBeBeyond() const {
  return std::any_of(course_.watches.begin(), course_.watches.end(),
                     [](const CheckWatch& w) { return w.mayBeWithin(); });
}

std::optional<Found> StopFinder::find(const PathPoint& a, const Segment& segment) {
  auto& watches = course_.watches;
  if (std::all_of(watches.begin(), watches.end(),
                  [&](CheckWatch& w) { return w.isFarFrom(segment); })) {
    for (CheckWatch& w : watches) {
      w.pass();
    }
    return std::nullopt;
  }
  keep();
  std::optional<Found> found;
  while (auto met = scan(segment)) {
    auto end = stop(a, segment, *met);
    if (end && !isContact(*met, *end)) {
      end.reset();
    }
    if (end || !met->hit.touch) {
      found = Found{*met, end};
      break;
    }
    // A near miss: look again, from behind it.
    restore();
    course_.watches[met->check].ignoreTouches(met->hit.high);
  }
  for (CheckWatch& w : course_.watches) {
    w.ignoreTouches(-1.0);
  }
  return found;
}

bool StopFinder::isEndless() {
  const PathPoint& start = course_.start;
  if (course_.path.flat() || !course_.path.axis.isFixed() || course_.turnsFirst ||
      !keepsAlong(course_.part.surface, start.tangent) ||
      !keepsAlong(course_.drive.surface, start.tangent)) {
    return false;
  }
  PathPoint far = start;
  far.toolEnd += tolerance::farAway * start.tangent;
  keep();
  if (scan(segmentBetween(start, far))) {
    restore();
    return false;
  }
  return true;
}

bool StopFinder::beginForFirstZero() {
  auto& watches = course_.watches;
  const bool any = std::any_of(watches.begin(), watches.end(),
                               [](const CheckWatch& w) { return w.hasFirstZero(); });
  for (CheckWatch& w : watches) {
    if (any) {
      w.beginForFirstZero(course_.start.toolEnd, course_.start.axis);
    }
  }
  return any;
}

/// A touch within the tolerance comes nearer where the band of the surface that turns the path
/// away leaves room.
PathPoint StopFinder::closer(const PathPoint& a,
                             const Segment& segment,
                             const Met& met,
                             const PathPoint& end) {
  const tool::Contact check = met.hit.field->at(end.toolEnd, end.axis);
  for (std::size_t i = 0; i < end.contacts.size(); ++i) {
    const double agreement = check.normal.dot(end.contacts[i].normal);
    if (std::abs(agreement) < touching) {
      continue;
    }
    Guide& g = course_.path.guides[i];
    const double rest = g.rest;
    g.rest = std::clamp(rest - check.gap / agreement, -g.inner, g.outer);
    const auto moved = meet(course_.path, a, segment, course_.watches[met.check], met.hit, 0.0);
    g.rest = rest;
    if (moved &&
        std::abs(met.hit.field->at(moved->toolEnd, moved->axis).gap) < std::abs(check.gap)) {
      return *moved;
    }
  }
  return end;
}

std::optional<PathPoint> StopFinder::atRest(const PathPoint& a,
                                            const Segment& segment,
                                            const Met& met) {
  return meet(course_.path, a, segment, course_.watches[met.check], met.hit, met.rest);
}

std::optional<PathPoint> StopFinder::stopAtEdge(const PathPoint& a,
                                                const Segment& segment,
                                                const Met& met) {
  if (course_.exact) {
    return std::nullopt;
  }
  const auto rests = course_.path.rests();
  for (Guide& g : course_.path.guides) {
    // The edge next to the stop: whether it saves a cut vector depends on where the last one ended.
    const bool outwards = 2.0 * g.rest > g.outer - g.inner;
    g.rest = g.field->flat() ? g.vertexGap() : g.edge(outwards);
  }
  auto end = atRest(a, segment, met);
  for (std::size_t i = 0; i < rests.size(); ++i) {
    course_.path.guides[i].rest = rests[i];
  }
  return end && isContact(met, *end) ? end : std::nullopt;
}

void StopFinder::keep() {
  kept_.clear();
  for (const CheckWatch& w : course_.watches) {
    kept_.push_back(w.progress());
  }
}

void StopFinder::forgetFree() {
  for (CheckWatch& w : course_.watches) {
    w.forgetFree();
  }
}

void StopFinder::restore(const std::vector<CheckWatch::Progress>& kept) {
  for (std::size_t i = 0; i < course_.watches.size(); ++i) {
    course_.watches[i].restore(kept[i]);
  }
}

}  // namespace arelem::motion
