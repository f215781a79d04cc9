#include "runtime/motion/check_watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/space/tolerance.h"
#include "runtime/geometry/least.h"

namespace arelem::motion {

namespace {
/// Slopes of a gap at most this may be rounding: of a stretch that is touched all along.
/// Dimensionless.
constexpr double levelSlope = tolerance::symmetric;
/// Finest step, as a share of the tolerance band: what is narrower is contact within the tolerance.
constexpr double fineShare = 0.25;
/// A tangency passes through its band in a length of the order of sqrt(band); this share of it is
/// one step.
constexpr double tangentShare = 0.05;
/// Cosine of the angle within which contact normals count as agreeing at a tangency.
constexpr double agreeing = 0.5;
/// Looking closely, no step is longer than this share of a cut vector; but where a tangency is
/// looked for none need be shorter than this many times the root of the band.
constexpr double closeShare = 0.0625;
constexpr double closeRoots = 2.0;
}  // namespace

CheckWatch::CheckWatch(const NamedSurface& surface,
                       ir::Condition condition,
                       int nth,
                       Tool tool,
                       const StopBand& allowed,
                       double pathBand)
    : surface_(surface),
      condition_(condition),
      nth_(nth),
      allowed_(allowed),
      band_(allowed.inner + allowed.outer),
      pathBand_(pathBand),
      tangent_(condition == ir::Condition::tanto || condition == ir::Condition::pstan),
      pointTool_(tool.cutter == nullptr),
      arm_(tool.cutter == nullptr ? 0.0 : std::hypot(tool.cutter->maxRadius(), tool.cutter->h)) {
  plus_ = makeField(surface.surface, 1.0, tool);
  minus_ = makeField(surface.surface, -1.0, tool);
}

void CheckWatch::note(double distance, const Vec3& place) {
  if (distance < nearest_) {
    nearest_ = distance;
    nearestPlace_ = place;
  }
}

/// Largest change of any gap per length of the segment. The axis turns fastest in the middle, by
/// twice the tangent of half the angle per length.
double CheckWatch::steepestTurning(const Segment& s) const {
  const double tangent = (s.axisTo - s.axisFrom).norm() / (s.axisTo + s.axisFrom).norm();
  return 1.0 + 2.0 * arm_ * tangent / std::max(s.length, tolerance::sameSide);
}

CheckWatch::Measure CheckWatch::measure(const Segment& s, double along) {
  const Vec3 at = s.at(along);
  const Vec3 axis = s.axisAt(along);
  if (close_) {
    looks_.push_back(along);
  }
  Measure m;
  m.field = plus_.get();
  tool::Contact c = plus_->at(at, axis);
  if (!pointTool_) {
    const tool::Contact other = minus_->at(at, axis);
    if (other.gap > c.gap) {
      m.field = minus_.get();
      c = other;
    }
  }
  m.value = c.gap;
  m.rate = isLinear(s) ? std::abs(c.normal.dot(s.direction)) : steepest(s);
  m.turn = slopeAlong(c, at, s.tangentAt(along), s.spin());
  note(std::abs(m.value), at);
  return m;
}

void CheckWatch::begin(const Vec3& toolEnd, const Vec3& axis) {
  Segment here;
  here.from = toolEnd;
  here.direction = here.tangentFrom = here.tangentTo = Vec3::Zero();
  here.axisFrom = here.axisTo = axis;
  const Measure m = measure(here, 0.0);
  now_.free = 0.0;
  now_.armed = std::abs(m.value) > band_;
  startedAt_ = !now_.armed;
  now_.outside = m.field;
  now_.positive = m.value > 0.0;
  now_.startedRemote = now_.positive;
  nearest_ = std::numeric_limits<double>::infinity();
}

std::optional<CheckWatch::Hit> CheckWatch::scan(const Segment& segment, Field& guide) {
  if (isFree(segment)) {
    pass(segment);
    return std::nullopt;
  }
  if (close_) {
    now_.free = 0.0;
    looks_.clear();
  }
  auto hit = tangent_ ? scanTangent(segment, guide) : scanCrossing(segment);
  if (close_ && !hit) {
    findNearest(segment, guide);
  }
  return hit;
}

/// Between the neighbors of each look that is nearer than they are.
void CheckWatch::findNearest(const Segment& s, Field& guide) {
  looks_.push_back(s.length);
  const std::vector<double> looks = std::exchange(looks_, {});
  if (tangent_) {
    findParallel(s, looks, guide);
  }
  const auto away = [&](double u) {
    return tangent_ ? missOfTangency(s, u, guide) : std::abs(measure(s, u).value);
  };
  std::vector<double> at;
  for (const double u : looks) {
    at.push_back(away(u));
  }
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t behind = std::min(i + 1, looks.size() - 1);
    const bool least = at[i] <= at[before] && at[i] <= at[behind] && at[i] < tolerance::farAway;
    if (least && at[i] <= nearest_ + looks[behind] - looks[before]) {
      geometry::narrowLeast(away, looks[before], looks[behind], [&](double value, double width) {
        return width > tolerance::sameSide && value <= nearest_ + steepest(s) * width;
      });
    }
  }
  looks_.clear();
}

/// Number of the zero that is asked for. Order of the positions: TO, PAST, TO, PAST from a remote
/// start, PAST, TO, ... from a violation.
int CheckWatch::wanted() const {
  return pointTool_ ? nth_ : 2 * nth_ - before();
}

/// Takes the measure over; true where its sign has changed. A measure of zero has no sign.
bool CheckWatch::crosses(const Measure& m) {
  if (!now_.armed) {
    if (std::abs(m.value) > band_) {
      now_.armed = true;
      now_.positive = m.value > 0.0;
      now_.startedRemote = pointTool_ || now_.positive;
    }
    return false;
  }
  const bool changed = std::abs(m.value) > tolerance::sameSide && (m.value > 0.0) != now_.positive;
  now_.positive = now_.positive != changed;
  return changed;
}

/// The length at which the measure has its zero, between one where it has the sign from before and
/// one where it has the other.
double CheckWatch::crossing(const Segment& s, double low, double high) {
  const bool now = now_.positive;
  const std::size_t looks = looks_.size();
  while (high - low > tolerance::sameSide) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) {
      break;
    }
    ((measure(s, middle).value > 0.0) == now ? high : low) = middle;
  }
  looks_.resize(looks);
  return high;
}

/// True where the measure came near zero and goes away again. A slope of zero has no direction.
bool CheckWatch::touchesHere(const Measure& m) {
  const double toward = now_.positive ? m.turn : -m.turn;
  if (std::abs(toward) <= tolerance::symmetric) {
    return false;
  }
  const bool turned =
      now_.armed && near(m) && now_.bandField == m.field && now_.lastTurn < 0.0 && toward > 0.0;
  now_.bandField = m.field;
  now_.lastTurn = toward;
  return turned;
}

/// True where a tool without thickness goes from one side of the surface to the other: the gap on
/// the one side closes where that on the other opens, and neither is negative.
bool CheckWatch::slipsThrough(const Measure& m, const Field* outsideBefore) const {
  return !pointTool_ && now_.armed && now_.positive && m.value > tolerance::sameSide && near(m) &&
         m.field != outsideBefore;
}

/// The gap that vanishes at a zero: entering, the one that was open before; leaving, the one that
/// opens.
Field* CheckWatch::vanishing(const Measure& m, Field* outsideBefore) {
  if (pointTool_) {
    return (m.value > 0.0) == (condition_ == ir::Condition::past) ? plus_.get() : minus_.get();
  }
  return m.value > 0.0 ? m.field : outsideBefore;
}

std::optional<CheckWatch::Hit> CheckWatch::scanCrossing(const Segment& s) {
  const double finest = std::max(fineShare * band_, tolerance::sameSide);
  const double finestTangent = std::max(tangentShare * std::sqrt(band_), tolerance::sameSide);
  double before = 0.0;
  double u = now_.free / steepest(s);
  for (;;) {
    const Measure m = measure(s, u);
    const double size = std::abs(m.value);
    // Where it starts at the surface the tool is on neither side.
    Field* const outsideBefore = now_.armed ? now_.outside : m.field;
    now_.outside = m.value > tolerance::sameSide ? m.field : now_.outside;
    if (crosses(m)) {
      if (++now_.seen == wanted()) {
        return Hit{before, u, vanishing(m, outsideBefore)};
      }
      now_.last = s.at(crossing(s, before, u));
      now_.bandField = nullptr;
    } else if (slipsThrough(m, outsideBefore)) {
      now_.seen += 2;
      if (now_.seen >= wanted()) {
        return Hit{before, u, now_.seen == wanted() ? m.field : outsideBefore};
      }
      now_.bandField = nullptr;
    } else if (touchesHere(m) && u > ignoredUntil_) {
      const int passed = pointTool_ ? 1 : 2;
      if (now_.seen < wanted() && wanted() <= now_.seen + passed) {
        now_.free = 0.0;
        return Hit{std::min(before, u - finestTangent), u, m.field, true};
      }
      if (touches(m.value)) {
        now_.seen += passed;
        now_.last = s.at(u);
      }
    }
    const double margin = now_.armed ? size : band_ - size + finest;
    double step = m.rate > 0.0 ? std::max(margin / m.rate, finest) : tolerance::farAway;
    if (now_.armed && near(m)) {
      // A touch shows in the slope: no longer steps here, and one look at the segment's end.
      step = std::min(step, finestTangent);
      step = u < s.length ? std::min(step, s.length - u) : step;
    }
    before = u;
    const double farther = size - nearest_;
    if (close_ && m.rate > 0.0) {
      step = std::min(step, std::max({closeShare * s.length, finest, farther / m.rate}));
    }
    u += step;
    if (u > s.length || before == s.length || isSpent()) {
      now_.free = std::max(0.0, margin - m.rate * (s.length - before));
      now_.farther = std::max(0.0, farther - m.rate * (s.length - before));
      return std::nullopt;
    }
  }
}

/// Where the gap along the path neither opens nor closes check surface and guide are parallel.
void CheckWatch::findParallel(const Segment& s, const std::vector<double>& looks, Field& guide) {
  for (Field* field : {plus_.get(), minus_.get()}) {
    const auto opens = [&](double u) -> bool {
      const tool::Contact c = field->at(s.at(u), s.axisAt(u));
      return slopeAlong(c, s.at(u), s.tangentAt(u), s.spin()) > 0.0;
    };
    bool second = opens(looks.front());
    for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
      double low = looks[i];
      double high = looks[i + 1];
      const bool first = std::exchange(second, opens(high));
      if (first == second) {
        continue;
      }
      while (high - low > tolerance::sameSide) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) {
          break;
        }
        (opens(middle) == first ? low : high) = middle;
      }
      const Vec3 place = s.at(low);
      const tool::Contact c = field->at(place, s.axisAt(low));
      const tool::Contact g = guide.at(place, s.axisAt(low));
      if (c.normal.dot(g.normal) <= agreeing) {
        continue;
      }
      // A tool between two surfaces that face each other is not what touches: these are as far
      // apart as the place on the guide is from the check surface.
      const Vec3 on =
          guide.flat() ? Vec3(place - (place - g.point).dot(g.normal) * g.normal) : g.point;
      const surface::Foot foot = footOn(surface_.surface, on);
      const double apart =
          foot.normal.dot(g.normal) < 0.0 ? std::abs(foot.distance) : foot.distance;
      const double gap = std::abs(c.gap) <= std::abs(apart) ? c.gap : apart;
      if (!parallel_ || std::abs(gap) < std::abs(parallel_->gap)) {
        parallel_ = {gap, place};
      }
    }
  }
}

/// The smaller gap of those whose contact agrees with that of the guide.
double CheckWatch::missOfTangency(const Segment& s, double u, Field& guide) {
  const Vec3 at = s.at(u);
  const Vec3 axis = s.axisAt(u);
  const Vec3 guideNormal = guide.at(at, axis).normal;
  double miss = tolerance::farAway;
  for (Field* field : {plus_.get(), minus_.get()}) {
    const tool::Contact c = field->at(at, axis);
    if (c.normal.dot(guideNormal) > agreeing) {
      miss = std::min(miss, std::abs(c.gap));
    }
  }
  note(miss, at);
  return miss;
}

std::optional<CheckWatch::Hit> CheckWatch::scanTangent(const Segment& s, Field& guide) {
  const double finest = std::max(tangentShare * std::sqrt(band_), tolerance::sameSide);
  double before = 0.0;
  double u = now_.free / steepest(s);
  for (;;) {
    const Vec3 at = s.at(u);
    const Vec3 a = s.axisAt(u);
    const Vec3 guideNormal = guide.at(at, a).normal;
    const Vec3 tangent = s.tangentAt(u);
    if (close_) {
      looks_.push_back(u);
    }
    Field* inside = nullptr;
    double turn = 0.0;
    double away = tolerance::farAway;
    double rate = steepest(s);
    for (Field* field : {plus_.get(), minus_.get()}) {
      const tool::Contact c = field->at(at, a);
      const double agreement = c.normal.dot(guideNormal);
      const double out = std::abs(c.gap) - band_ - pathBand_;
      if (out <= 0.0 && (agreement > agreeing)) {
        inside = field;
        turn = slopeAlong(c, at, tangent, s.spin());
      } else if (std::abs(out) < away) {
        away = std::abs(out);
        rate = isLinear(s) ? std::abs(c.normal.dot(s.direction)) : steepest(s);
      }
      if (agreement > agreeing) {
        note(std::abs(c.gap), at);
      }
    }
    if (inside != nullptr) {
      // A flat bottom touches over a whole stretch, along which only rounding gives the slope a
      // sign: the stop is where the stretch begins.
      const double level = std::copysign(levelSlope, now_.lastTurn);
      if (now_.armed && now_.bandField == inside && u > ignoredUntil_ &&
          (turn > level) != (now_.lastTurn > level)) {
        now_.lastTurn = turn;
        now_.free = 0.0;
        // A touch at the end of a cut vector shows at the start of the next one: it may lie before.
        return Hit{std::min(before, u - finest), u, inside, true, level};
      }
      // A start at a tangency is not counted; it must be left first.
      now_.armed = now_.armed || std::abs(turn) > tolerance::nullDirection;
      now_.lastTurn = turn;
    } else {
      now_.armed = true;
    }
    now_.bandField = inside;
    before = u;
    double open = rate > 0.0 ? away / rate : tolerance::farAway;
    open = close_ ? std::min(open, std::max(closeShare * s.length, closeRoots * std::sqrt(band_)))
                  : open;
    u += inside != nullptr ? finest : std::max(open, finest);
    if (u >= s.length || isSpent()) {
      now_.free = inside != nullptr ? 0.0 : std::max(0.0, away - rate * (s.length - before));
      return std::nullopt;
    }
  }
}

}  // namespace arelem::motion
