#include "runtime/motion/path.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
constexpr int rootLimit = 200;
constexpr int widenLimit = 12;

/// Finds a zero of f in [low, high] where the signs differ: regula falsi with the Illinois rule.
template <class F>
std::optional<double> root(F f, double low, double high) {
  std::optional<double> fl = f(low);
  std::optional<double> fh = f(high);
  // The chord only approximates the path: the zero may lie a little outside the bracket.
  const double grow = std::max(high - low, tolerance::coincidence);
  for (int i = 0; i < widenLimit && fl && fh && (*fl > 0.0) == (*fh > 0.0); ++i) {
    low -= grow * (1 << i);
    high += grow * (1 << i);
    fl = f(low);
    fh = f(high);
  }
  if (!fl || !fh || (*fl > 0.0) == (*fh > 0.0)) {
    return std::nullopt;
  }
  double a = low, b = high, fa = *fl, fb = *fh;
  for (int i = 0; i < rootLimit && fa != fb; ++i) {
    const double middle = i % 8 == 7 ? 0.5 * (a + b) : b - fb * (b - a) / (fb - fa);
    const auto fm = f(middle);
    if (!fm) {
      return std::nullopt;
    }
    if (*fm == 0.0 || std::abs(b - a) <= 1e-15 * (1.0 + std::abs(middle))) {
      return middle;
    }
    if ((*fm > 0.0) != (fb > 0.0)) {
      a = b;
      fa = fb;
    } else {
      fa *= 0.5;
    }
    b = middle;
    fb = *fm;
  }
  return b;
}
}  // namespace

bool Path::aim(PathPoint& point, const Vec3& towards) const {
  const Vec3 common = point.contacts[0].normal.cross(point.contacts[1].normal);
  const double length = common.norm();
  if (length <= tolerance::nullDirection) {
    return false;
  }
  point.tangent = common / (common.dot(towards) < 0.0 ? -length : length);
  return true;
}

PathPoint Path::look(const Vec3& toolEnd, const Vec3& towards) {
  PathPoint p;
  p.toolEnd = toolEnd;
  p.axis = axis.at(toolEnd);
  for (std::size_t i = 0; i < 2; ++i) {
    p.contacts[i] = guides[i].field->at(toolEnd, p.axis);
  }
  if (!aim(p, towards)) {
    p.tangent = towards;
  }
  return p;
}

std::optional<PathPoint> Path::step(const PathPoint& from,
                                    double along,
                                    const std::array<double, 2>& gaps,
                                    double accept) {
  // Second-order prediction: the path bends by -bend along each contact normal.
  const Vec3& n0 = from.contacts[0].normal;
  const Vec3& n1 = from.contacts[1].normal;
  const double c = n0.dot(n1);
  const double det = 1.0 - c * c;
  Vec3 guess = from.toolEnd + along * from.tangent;
  if (det > tolerance::nullDirection) {
    const double r0 = gaps[0] - from.contacts[0].gap - 0.5 * along * along * guides[0].bend;
    const double r1 = gaps[1] - from.contacts[1].gap - 0.5 * along * along * guides[1].bend;
    guess += ((r0 - c * r1) * n0 + (r1 - c * r0) * n1) / det;
  }
  const std::array wanted{Wanted{guides[0].field.get(), gaps[0]},
                          Wanted{guides[1].field.get(), gaps[1]}};
  const std::array across{Constraint{from.tangent, from.toolEnd + along * from.tangent}};
  const Settled settled = settle(guess, axis, wanted, across, accept);
  if (!settled.ok) {
    return std::nullopt;
  }
  PathPoint p;
  p.toolEnd = settled.toolEnd;
  p.axis = settled.axis;
  p.contacts = {settled.contacts[0], settled.contacts[1]};
  if (!aim(p, from.tangent)) {
    return std::nullopt;
  }
  return p;
}

double Path::fit(const PathPoint& a, const PathPoint& b) {
  const Vec3 chord = b.toolEnd - a.toolEnd;
  const double length = chord.norm();
  if (length <= 0.0) {
    return tolerance::farAway;
  }
  const Vec3 direction = chord / length;
  const Vec3 middle = a.toolEnd + 0.5 * chord;
  const Vec3 middleAxis = axis.at(middle);
  double factor = tolerance::farAway;
  for (std::size_t i = 0; i < 2; ++i) {
    if (guides[i].flat()) {
      continue;
    }
    const tool::Contact& from = a.contacts[i];
    const tool::Contact& to = b.contacts[i];
    const tool::Contact between = guides[i].field->at(middle, middleAxis);
    const double slope = between.normal.dot(direction);
    const ChordProfile first{from.gap, from.normal.dot(direction), between.gap, slope,
                             0.5 * length};
    const ChordProfile second{between.gap, slope, to.gap, to.normal.dot(direction), 0.5 * length};
    // A start outside its band by the slack allowed there must not stop the motion.
    const double inner = std::max({guides[i].inner, -from.gap, -to.gap});
    const double outer = std::max({guides[i].outer, from.gap, to.gap});
    factor = std::min(factor, fittingFactor(first, second, inner, outer));
    factor = std::min(factor, ridge(i, {a.toolEnd, from, first, inner, outer}, middle, between));
    factor = std::min(factor, ridge(i, {middle, between, second, inner, outer}, b.toolEnd, to));
  }
  return factor;
}

/// Where the contact jumps from one place of the cutter to another the gap has a ridge that no
/// cubic shows: measured where the tangents from both ends cross.
double Path::ridge(std::size_t guide, const Half& half, const Vec3& end, const tool::Contact& to) {
  const Vec3 jump = (to.point - end) - (half.from.point - half.start);
  const ChordProfile& c = half.profile;
  const double bend = c.slopeFrom - c.slopeTo;
  if (jump.norm() <= c.length || bend <= 0.0) {
    return tolerance::farAway;
  }
  const double at = (c.gapTo - c.gapFrom - c.slopeTo * c.length) / bend;
  const double crossing = c.gapFrom + c.slopeFrom * at;
  if (at <= 0.0 || at >= c.length || crossing <= half.outer) {
    return tolerance::farAway;
  }
  const Vec3 place = half.start + at / c.length * (end - half.start);
  const double gap = guides[guide].field->at(place, axis.at(place)).gap;
  const double line = c.gapFrom + at / c.length * (c.gapTo - c.gapFrom);
  return gap <= half.outer || gap <= line
             ? tolerance::farAway
             : std::sqrt(std::max(0.0, half.outer - line) / (gap - line));
}

std::optional<PathPoint> meet(Path& path,
                              const PathPoint& from,
                              const Segment& segment,
                              const CheckWatch& watch,
                              const CheckWatch::Hit& hit,
                              double checkRest) {
  const double middle = 0.5 * (hit.low + hit.high);
  const Vec3 guess = segment.from + middle * segment.direction;
  if (!watch.isTangent()) {
    const std::array wanted{Wanted{path.guides[0].field.get(), path.guides[0].rest},
                            Wanted{path.guides[1].field.get(), path.guides[1].rest},
                            Wanted{hit.field, checkRest}};
    const Settled settled = settle(guess, path.axis, wanted, {});
    const double bands = watch.band() + path.guides[0].outer + path.guides[0].inner +
                         path.guides[1].outer + path.guides[1].inner;
    const PathPoint there = path.look(settled.toolEnd, from.tangent);
    const double steepness =
        std::max(std::abs(settled.contacts[2].normal.dot(there.tangent)), 0.02);
    if (settled.ok &&
        (settled.toolEnd - guess).norm() <= hit.high - hit.low + 4.0 * bands / steepness) {
      return there;
    }
  }
  // Along the path: the gap itself, or at a tangency its slope, changes sign in the bracket.
  const double scale = segment.direction.dot(from.tangent);
  const auto measure = [&](double s) -> std::optional<double> {
    const auto p = path.step(from, s * scale, path.rests(), 0.0);
    if (!p) {
      return std::nullopt;
    }
    const tool::Contact c = hit.field->at(p->toolEnd, p->axis);
    return watch.isTangent() ? c.normal.dot(p->tangent) : c.gap - checkRest;
  };
  const auto s = root(measure, hit.low, hit.high);
  return s ? path.step(from, *s * scale, path.rests(), 0.0) : std::nullopt;
}

}  // namespace arelem::motion
