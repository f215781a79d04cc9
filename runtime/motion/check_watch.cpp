#include "runtime/motion/check_watch.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::motion {

namespace {
/// Finest step, as a share of the tolerance band: what is narrower is contact within the tolerance.
constexpr double fineShare = 0.25;
/// A tangency passes through its band in a length of the order of sqrt(band); this share of it is
/// one step.
constexpr double tangentShare = 0.05;
/// Cosine of the angle within which contact normals count as agreeing at a tangency.
constexpr double agreeing = 0.5;
/// A changing tool axis adds to the change of a gap; the proof then keeps this share of the free
/// path.
constexpr double turningAxisShare = 0.5;
/// What is left of a free margin at the end of a segment, as path in any direction: the rate found
/// on the segment holds for its direction only.
double freeBeyond(double margin, double rate, double rest, const AxisRule& axis) {
  const double left = std::max(0.0, margin - rate * rest);
  return axis.normalTo != nullptr ? turningAxisShare * left : left;
}
}  // namespace

CheckWatch::CheckWatch(const NamedSurface& surface,
                       ir::Condition condition,
                       int nth,
                       Tool tool,
                       double band,
                       double pathBand)
    : surface_(surface),
      condition_(condition),
      nth_(nth),
      band_(band),
      pathBand_(pathBand),
      tangent_(condition == ir::Condition::tanto || condition == ir::Condition::pstan),
      pointTool_(tool.cutter == nullptr || (tool.cutter->isPoint() && tool.thick == 0.0)) {
  plus_ = makeField(surface.surface, 1.0, tool);
  minus_ = makeField(surface.surface, -1.0, tool);
}

void CheckWatch::note(double distance, const Vec3& place) {
  if (distance < nearest_) {
    nearest_ = distance;
    nearestPlace_ = place;
  }
}

CheckWatch::Measure CheckWatch::measure(const Vec3& at,
                                        const AxisRule& axis,
                                        const Vec3& direction) {
  const Vec3 a = axis.at(at);
  const tool::Contact p = plus_->at(at, a);
  Measure m;
  m.field = plus_.get();
  m.value = p.gap;
  Vec3 normal = p.normal;
  if (!pointTool_) {
    const tool::Contact q = minus_->at(at, a);
    if (q.gap > p.gap) {
      m.field = minus_.get();
      m.value = q.gap;
      normal = q.normal;
    }
  }
  const double turning = axis.normalTo != nullptr ? 1.0 / turningAxisShare : 1.0;
  m.rate = plus_->flat() && axis.normalTo == nullptr ? std::abs(normal.dot(direction)) : turning;
  note(std::abs(m.value), at);
  return m;
}

void CheckWatch::begin(const Vec3& toolEnd, const AxisRule& axis) {
  now_.free = 0.0;
  const Measure m = measure(toolEnd, axis, Vec3::Zero());
  now_.armed = std::abs(m.value) > band_;
  now_.outside = m.field;
  now_.positive = m.value > 0.0;
  now_.startedRemote = now_.positive;
  nearest_ = std::numeric_limits<double>::infinity();
}

std::optional<CheckWatch::Hit> CheckWatch::scan(const Segment& segment,
                                                const AxisRule& axis,
                                                Field& guide) {
  if (now_.free > segment.length) {
    now_.free -= segment.length;
    return std::nullopt;
  }
  return tangent_ ? scanTangent(segment, axis, guide) : scanCrossing(segment, axis);
}

std::optional<CheckWatch::Hit> CheckWatch::scanCrossing(const Segment& s, const AxisRule& axis) {
  const double finest = std::max(fineShare * band_, tolerance::sameSide);
  const bool both = pointTool_;  // TO, ON and PAST coincide
  double before = 0.0;
  double u = now_.free;
  for (;;) {
    const Measure m = measure(s.from + u * s.direction, axis, s.direction);
    const double size = std::abs(m.value);
    Field* const outsideBefore = now_.outside;
    now_.outside = m.value > 0.0 ? m.field : now_.outside;
    if (!now_.armed) {
      if (size > band_) {
        now_.armed = true;
        now_.positive = m.value > 0.0;
        now_.startedRemote = both || now_.positive;
      }
    } else if ((m.value > 0.0) != now_.positive) {
      now_.positive = !now_.positive;
      ++now_.seen;
      // Order of the positions: TO, PAST, TO, PAST from a remote start, PAST, TO, ... from a
      // violation.
      const bool past = condition_ == ir::Condition::past;
      const int wanted = both ? nth_ : 2 * nth_ - (past == now_.startedRemote ? 0 : 1);
      if (now_.seen == wanted) {
        // The gap that vanishes there: entering, the one that was open before; leaving, the one
        // that opens.
        Field* field = m.value > 0.0 ? m.field : outsideBefore;
        if (both) {
          field = (m.value > 0.0) == past ? plus_.get() : minus_.get();
        }
        return Hit{before, u, field};
      }
    }
    const double margin = now_.armed ? size : band_ - size + finest;
    const double step = m.rate > 0.0 ? std::max(margin / m.rate, finest) : tolerance::farAway;
    before = u;
    u += step;
    if (u >= s.length) {
      now_.free = freeBeyond(margin, m.rate, s.length - before, axis);
      return std::nullopt;
    }
  }
}

std::optional<CheckWatch::Hit> CheckWatch::scanTangent(const Segment& s,
                                                       const AxisRule& axis,
                                                       Field& guide) {
  const double finest = std::max(tangentShare * std::sqrt(band_), tolerance::sameSide);
  double before = 0.0;
  double u = now_.free;
  for (;;) {
    const Vec3 at = s.from + u * s.direction;
    const Vec3 a = axis.at(at);
    const Vec3 guideNormal = guide.at(at, a).normal;
    const Vec3 tangent =
        s.tangentFrom + u / std::max(s.length, finest) * (s.tangentTo - s.tangentFrom);
    Field* inside = nullptr;
    double turn = 0.0;
    double away = tolerance::farAway;
    double rate = 1.0;
    for (Field* field : {plus_.get(), minus_.get()}) {
      const tool::Contact c = field->at(at, a);
      const double agreement = c.normal.dot(guideNormal);
      const double out = std::abs(c.gap) - band_ - pathBand_;
      if (out <= 0.0 && (agreement > agreeing)) {
        inside = field;
        turn = c.normal.dot(tangent);
      } else if (std::abs(out) < away) {
        away = std::abs(out);
        rate =
            field->flat() && axis.normalTo == nullptr ? std::abs(c.normal.dot(s.direction)) : 1.0;
      }
      if (agreement > agreeing) {
        note(std::abs(c.gap), at);
      }
    }
    if (inside != nullptr) {
      if (now_.armed && now_.bandField == inside && (turn > 0.0) != (now_.lastTurn > 0.0)) {
        now_.lastTurn = turn;
        now_.free = 0.0;
        return Hit{before, u, inside};
      }
      // A start at a tangency is not counted; it must be left first.
      now_.armed = now_.armed || std::abs(turn) > tolerance::nullDirection;
      now_.lastTurn = turn;
    } else {
      now_.armed = true;
    }
    now_.bandField = inside;
    before = u;
    const double open = rate > 0.0 ? away / rate : tolerance::farAway;
    u += inside != nullptr ? finest : std::max(open, finest);
    if (u >= s.length) {
      now_.free = inside != nullptr ? 0.0 : freeBeyond(away, rate, s.length - before, axis);
      return std::nullopt;
    }
  }
}

}  // namespace arelem::motion
