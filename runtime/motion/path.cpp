#include "runtime/motion/path.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/motion/settle.h"

namespace arelem::motion {

namespace {
/// A place that is farther from the prediction than this share of the step is on another branch of
/// the path.
constexpr double jumpShare = 2.0;
/// How far ahead the contact behind a corner is looked for, as a share of the band.
constexpr double aheadOfCorner = 0.01;
/// Cosine of the turn up to which a path through a crossing of two goes straight on.
constexpr double straightOn = 0.87;
/// Contact normals whose cosine is above this are those of one smooth path.
constexpr double sameContact = 0.999;
}  // namespace

bool Path::aim(PathPoint& point, const Vec3& towards) {
  Vec3 n0 = point.contacts[0].normal;
  Vec3 n1 = point.contacts[1].normal;
  if (!axis.isFixed()) {
    const Eigen::Matrix3d turning = axis.change(point.toolEnd).transpose();
    n0 += turning * changeWithAxis(point.contacts[0], point.toolEnd, point.axis);
    n1 += turning * changeWithAxis(point.contacts[1], point.toolEnd, point.axis);
  }
  const Vec3 common = n0.cross(n1);
  const double length = common.norm();
  if (length <= tolerance::nullDirection) {
    return false;
  }
  point.sense = common.dot(towards) < 0.0 ? -1.0 : 1.0;
  point.tangent = common * (point.sense / length);
  return true;
}

/// Where the tangent of one sense turns back, a contact has gone to another side of the cutter; if
/// none has and the path goes straight on, two branches of it cross between the places.
bool Path::aimBehind(PathPoint& point, const PathPoint& from) {
  if (!aim(point, from.tangent)) {
    return false;
  }
  const bool jumps = point.contacts[0].normal.dot(from.contacts[0].normal) <= 0.0 ||
                     point.contacts[1].normal.dot(from.contacts[1].normal) <= 0.0 ||
                     point.tangent.dot(from.tangent) < straightOn;
  if (jumps && point.sense == -from.sense) {
    point.sense = from.sense;
    point.tangent = -point.tangent;
  }
  return true;
}

PathPoint Path::lookWith(const Vec3& toolEnd, const Vec3& toolAxis, const Vec3& towards) {
  PathPoint p;
  p.toolEnd = toolEnd;
  p.axis = toolAxis;
  for (std::size_t i = 0; i < guides.size(); ++i) {
    p.contacts[i] = guides[i].field->at(toolEnd, toolAxis);
  }
  if (!aim(p, towards)) {
    p.tangent = towards;
  }
  return p;
}

PathPoint Path::look(const Vec3& toolEnd, const Vec3& towards) {
  return lookWith(toolEnd, axis.at(toolEnd), towards);
}

Vec3 Path::spinAt(const PathPoint& p) {
  return axis.isFixed() ? Vec3(Vec3::Zero())
                        : Vec3(p.axis.cross(axis.change(p.toolEnd) * p.tangent));
}

std::optional<PathPoint> Path::standing(const Vec3& near,
                                        const Vec3& towards,
                                        const std::array<double, 2>& gaps,
                                        const Vec3* toolAxis) {
  AxisRule held(toolAxis != nullptr ? *toolAxis : Vec3::UnitZ());
  AxisRule& rule = toolAxis != nullptr ? held : axis;
  const std::array wanted{Wanted{guides[0].field.get(), gaps[0]},
                          Wanted{guides[1].field.get(), gaps[1]}};
  const std::array across{Constraint{towards, near}};
  const Settled settled = settle(near, rule, wanted, across);
  return settled.ok ? std::optional(lookWith(settled.toolEnd, settled.axis, towards))
                    : std::nullopt;
}

namespace {
/// The plane square to the path in which a step along it ends.
Constraint acrossAt(const PathPoint& from, double along) {
  return {from.tangent, from.toolEnd + along * from.tangent};
}
}  // namespace

bool Path::step(const PathPoint& from,
                double along,
                const std::array<double, 2>& gaps,
                double accept,
                PathPoint& to) {
  // The path bends by -bend along each contact normal.
  const Vec3& n0 = from.contacts[0].normal;
  const Vec3& n1 = from.contacts[1].normal;
  const double c = n0.dot(n1);
  const double det = 1.0 - c * c;
  const std::array corrections{guides[0].correction(along), guides[1].correction(along)};
  Vec3 guess = from.toolEnd + along * from.tangent;
  if (det > tolerance::nullDirection) {
    const auto drop = [&](std::size_t i) {
      const Guide& g = guides[i];
      return gaps[i] - from.contacts[i].gap -
             0.5 * along * along * (g.bend + along / 3.0 * g.trend) + corrections[i];
    };
    const double r0 = drop(0);
    const double r1 = drop(1);
    const Vec3 aside = ((r0 - c * r1) * n0 + (r1 - c * r0) * n1) / det;
    // A circle lies aside of its parabola by this share; next to `from` the way aside is that from
    // one gap to another.
    const double steep = aside.squaredNorm() / (along * along);
    guess += (steep < 1.0 ? 1.0 + steep : 1.0) * aside;
  }
  to.toolEnd = guess;
  to.axis = axis.at(guess);
  double most = std::abs(acrossAt(from, along).missedAt(guess));
  for (std::size_t i = 0; i < guides.size(); ++i) {
    to.contacts[i] = guides[i].field->at(guess, to.axis);
    const double missed = gaps[i] - to.contacts[i].gap;
    most = std::max(most, std::abs(missed));
    if (accept > 0.0) {
      guides[i].error = (corrections[i] + missed) / (along * along * along);
    }
  }
  // Mostly the place that was foretold does.
  const bool there = most <= std::max(roundingAt(guess), accept);
  // An axis that does not settle there may do so on the way: a shorter step tells.
  return (there || settleStep(from, along, gaps, accept, to)) && axis.settles() &&
         aimBehind(to, from);
}

/// Goes on from the place that was foretold, which is measured; false where that leads to another
/// branch of the path.
bool Path::settleStep(const PathPoint& from,
                      double along,
                      const std::array<double, 2>& gaps,
                      double accept,
                      PathPoint& at) {
  const std::array across{acrossAt(from, along)};
  const std::array wanted{Wanted{guides[0].field.get(), gaps[0]},
                          Wanted{guides[1].field.get(), gaps[1]}};
  Settled settled;
  settled.toolEnd = at.toolEnd;
  settled.axis = at.axis;
  std::copy(at.contacts.begin(), at.contacts.end(), settled.contacts.begin());
  settleOn(settled, axis, wanted, across, accept);
  const double reach = jumpShare * jumpShare * (at.toolEnd - from.toolEnd).squaredNorm();
  if (!settled.ok || (settled.toolEnd - at.toolEnd).squaredNorm() > reach) {
    return false;
  }
  at.toolEnd = settled.toolEnd;
  at.axis = settled.axis;
  std::copy_n(settled.contacts.begin(), at.contacts.size(), at.contacts.begin());
  return true;
}

/// Where the new contact holds the tool back, the gap that held it before opens; where it lets the
/// tool go (a rim that leaves an edge), that gap closes behind the corner.
std::optional<PathPoint> Path::roundCorner(const PathPoint& at) {
  const Vec3 way = aheadOfCorner * band() * at.tangent;
  const Vec3 ahead = at.toolEnd + way;
  const Vec3 axisAhead = axis.at(ahead);
  PathPoint turned = at;
  Vec3 towards = Vec3::Zero();
  for (std::size_t i = 0; i < guides.size(); ++i) {
    tool::Contact next = guides[i].field->at(ahead, axisAhead);
    if (next.normal.dot(at.contacts[i].normal) > sameContact) {
      continue;
    }
    towards += next.gap <= at.contacts[i].gap ? at.contacts[i].normal : -at.contacts[i].normal;
    next.gap = at.contacts[i].gap;
    next.point -= way;
    turned.contacts[i] = next;
  }
  const bool turns = !towards.isZero(0.0) && aim(turned, towards);
  // What goes back the way that it came goes round no corner.
  return turns && turned.tangent.dot(at.tangent) > -sameContact ? std::optional(turned)
                                                                : std::nullopt;
}

Segment segmentBetween(const PathPoint& a, const PathPoint& b) {
  Segment s;
  s.from = a.toolEnd;
  s.direction = b.toolEnd - a.toolEnd;
  s.length = s.direction.norm();
  s.direction = s.length > 0.0 ? Vec3(s.direction / s.length) : a.tangent;
  s.tangentFrom = a.tangent;
  s.tangentTo = b.tangent;
  s.axisFrom = a.axis;
  s.axisTo = b.axis;
  s.turning = a.axis != b.axis;
  return s;
}

}  // namespace arelem::motion
