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
  point.tangent = common / (common.dot(towards) < 0.0 ? -length : length);
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
  const double reach = jumpShare * (guess - from.toolEnd).norm();
  if (!settled.ok || (settled.toolEnd - guess).norm() > reach) {
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
  const bool turning = a.axis != b.axis;
  if (length <= 0.0 && !turning) {
    return tolerance::farAway;
  }
  // A cut vector that only turns the axis is measured by the angle.
  const double scale = length > 0.0 ? length : (b.axis - a.axis).norm();
  const Vec3 direction = chord / scale;
  const Vec3 turn = turning ? spin(a.axis, b.axis, scale) : Vec3(Vec3::Zero());
  const Vec3 middle = a.toolEnd + 0.5 * chord;
  const Vec3 middleAxis = turning ? Vec3((a.axis + b.axis).normalized()) : a.axis;
  double factor = tolerance::farAway;
  for (std::size_t i = 0; i < guides.size(); ++i) {
    if (guides[i].field->flat() && !turning) {
      continue;
    }
    const tool::Contact& from = a.contacts[i];
    const tool::Contact& to = b.contacts[i];
    const tool::Contact between = guides[i].field->at(middle, middleAxis);
    const double slope = slopeAlong(between, middle, direction, turn);
    const ChordProfile first{from.gap, slopeAlong(from, a.toolEnd, direction, turn), between.gap,
                             slope, 0.5 * scale};
    const ChordProfile second{between.gap, slope, to.gap,
                              slopeAlong(to, b.toolEnd, direction, turn), 0.5 * scale};
    // A start outside its band by the slack allowed there must not stop the motion.
    const double inner = std::max({guides[i].inner, -from.gap, -to.gap});
    const double outer = std::max({guides[i].outer, from.gap, to.gap});
    factor = std::min({factor, fittingFactor(first, second, inner, outer),
                       ridge(*guides[i].field, {a.toolEnd, middle, a.axis, middleAxis, from,
                                                between, first, inner, outer}),
                       ridge(*guides[i].field, {middle, b.toolEnd, middleAxis, b.axis, between, to,
                                                second, inner, outer})});
    if (factor >= 1.0 - tolerance::coincidence) {
      const certify::Chord straight(a.toolEnd, b.toolEnd, a.axis, b.axis);
      factor = std::min(factor, guides[i].field->judge(straight, inner, outer));
    }
  }
  return factor;
}

/// Where the contact jumps from one place of the cutter to another the gap has a ridge that no
/// cubic shows: measured where the tangents from both ends cross.
double Path::ridge(Field& field, const Half& half) const {
  const Vec3 jump = (half.to.point - half.end) - (half.from.point - half.start);
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
  const double share = at / c.length;
  const Vec3 place = half.start + share * (half.end - half.start);
  const Vec3 toolAxis = (half.axisStart + share * (half.axisEnd - half.axisStart)).normalized();
  const double gap = field.at(place, toolAxis).gap;
  const double line = c.gapFrom + share * (c.gapTo - c.gapFrom);
  return gap <= half.outer || gap <= line
             ? tolerance::farAway
             : std::sqrt(std::max(0.0, half.outer - line) / (gap - line));
}

double Path::fitWithTurn(const PathPoint& a, const PathPoint& b) {
  const double factor = fit(a, b);
  const double sine = axis.isFixed() ? 0.0 : a.axis.cross(b.axis).norm();
  return sine > 0.0 ? std::min(factor, tolerance::axisTurn / std::atan2(sine, a.axis.dot(b.axis)))
                    : factor;
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
