#include "runtime/motion/arrival.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// By this factor a cut vector is longer than it was to be.
constexpr double clearlyLonger = 1.001;
/// A last cut vector with a smaller cosine to the path leads across it.
constexpr double sidelong = 0.5;
}  // namespace

void Arrival::put(PathPoint& last, const PathPoint& to) {
  if (stops_.mayBeBeyond()) {
    trail_.hold(last, to);
    stops_.remember();
  } else {
    trail_.put(last, to);
  }
  last = to;
  hasMoved_ = true;
}

bool Arrival::arrive(
    PathPoint& last, const PathPoint& stop, const Segment& segment, const Met& met, double& cap) {
  const Vec3 way = stop.toolEnd - last.toolEnd;
  const bool there = hasMoved_ && way.norm() <= nearStop();
  const double along = way.dot(last.tangent);
  const bool beyond =
      hasMoved_ && !there && along < sidelong * way.norm() && stops_.isWithin(last, met);
  const auto before = beyond && !hasWithdrawn_ ? trail_.heldFrom() : std::nullopt;
  if (!before) {
    if (!there && !(beyond && along < 0.0)) {
      trail_.put(last, stop);
      last = stop;
    }
    return true;
  }
  const auto fits = along < 0.0              ? fitting(*before, last, segment, met, stop)
                    : reaches(*before, stop) ? std::optional(stop)
                                             : std::nullopt;
  trail_.withdraw();
  last = *before;
  if (fits) {
    trail_.put(last, *fits);
    last = *fits;
    return true;
  }
  hasWithdrawn_ = true;
  stops_.recall();
  cap = shared(last, stop);
  return false;
}

double Arrival::nearStop() const {
  double near = tolerance::sameSide;
  for (const Guide& g : course_.path.guides) {
    // Along planes on which the axis turns cut vectors end this far beside the stops.
    near += g.field->flat() ? 2.0 * Guide::aimShare * (g.inner + g.outer) : 0.0;
  }
  return near;
}

/// The stop, or that at the band's edge, if one cut vector from a place reaches it within the
/// bands; `a` begins the segment on which the stop was found.
std::optional<PathPoint> Arrival::fitting(const PathPoint& from,
                                          const PathPoint& a,
                                          const Segment& segment,
                                          const Met& met,
                                          const PathPoint& end) {
  if (course_.path.fitWithTurn(from, end) >= 1.0 - fitShare) {
    return end;
  }
  const auto edge = stops_.stopAtEdge(a, segment, met);
  return edge && course_.path.fitWithTurn(from, *edge) >= 1.0 - fitShare ? edge : std::nullopt;
}

bool Arrival::reaches(const PathPoint& from, const PathPoint& end) {
  return (end.toolEnd - from.toolEnd).norm() <= longest_ + tolerance::sameSide &&
         course_.path.fitWithTurn(from, end) >= 1.0 - fitShare;
}

double Arrival::shared(const PathPoint& from, const PathPoint& end) {
  const double factor = course_.path.fitWithTurn(from, end);
  return (end.toolEnd - from.toolEnd).norm() / std::max(2.0, std::ceil(1.0 / factor));
}

std::optional<PathPoint> Arrival::fittingStop(const PathPoint& a,
                                              const Segment& segment,
                                              const Found& found,
                                              double& cap) {
  const PathPoint& end = *found.end;
  if (trail_.count() + 1 >= limits_.points) {
    return end;
  }
  if (auto fits = fitting(a, a, segment, found.met, end)) {
    return fits;
  }
  const double before = cap;
  cap = shared(a, end);
  // Aside of its path a cut vector may come out longer than it was to be, and pass the stop.
  const bool passes = segment.length >= (end.toolEnd - a.toolEnd).norm();
  if (passes && segment.length > clearlyLonger * before && before > tolerance::coincidence) {
    cap = std::min(cap, 0.5 * before);
  }
  return cap <= tolerance::sameSide ? std::optional(end) : std::nullopt;
}

}  // namespace arelem::motion
