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
/// A tool that went a length within the band of a surface looks for tangencies in steps of at least
/// this share of that length.
constexpr double nearShare = 1e-3;
/// A facet whose slope along the path is at most this is level but for the rounding of its file,
/// which is 6e-8 of the coordinates. Dimensionless.
constexpr double levelFacet = 1e-6;
/// Segments longer than this are those of a path that is straight for ever. Part unit.
constexpr double endless = 0.5 * tolerance::farAway;
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
      pace_(surface.surface, tool.cutter),
      thickPassesTool_(tool.cutter != nullptr && tool.thick < -tool.cutter->maxRadius()),
      toolRadius_(tool.cutter == nullptr ? 0.0 : tool.cutter->maxRadius() + tool.thick),
      arm_(tool.cutter == nullptr ? 0.0 : std::hypot(tool.cutter->maxRadius(), tool.cutter->h)) {
  plus_ = makeField(surface.surface, 1.0, tool);
  minus_ = makeField(surface.surface, -1.0, tool);
}

/// Largest change of any gap per length of the segment. The axis turns fastest in the middle, by
/// twice the tangent of half the angle per length.
double CheckWatch::steepestTurning(const Segment& s) const {
  const double tangent = (s.axisTo - s.axisFrom).norm() / (s.axisTo + s.axisFrom).norm();
  return 1.0 + 2.0 * arm_ * tangent / std::max(s.length, tolerance::sameSide);
}

double CheckWatch::tangentStep() const {
  return std::max(tangentShare * std::sqrt(band_), tolerance::sameSide);
}

/// The longest step within the band, where a tangency shows in the slope only.
double CheckWatch::nearStep(const Segment& s, double finest) const {
  const double speed =
      !s.turning && !s.isArc()
          ? std::max({pace_.most(s.direction), pace_.most(s.tangentFrom), pace_.most(s.tangentTo)})
          : 1.0;
  return std::max(finest / std::max(speed, tolerance::rounding), nearShare * now_.nearFor);
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
  m.rate = closing(s, m.field, c);
  if (!pointTool_) {
    const tool::Contact other = minus_->at(at, axis);
    const double otherRate = closing(s, minus_.get(), other);
    const double less = std::min(c.gap, other.gap);
    const double lessRate = other.gap > c.gap ? m.rate : otherRate;
    if (other.gap > c.gap) {
      m.field = minus_.get();
      c = other;
      m.rate = otherRate;
    }
    if (c.gap < 0.0) {
      // In violation the tool may leave to either side.
      m.rate = std::max(m.rate, lessRate * c.gap / less);
    }
  }
  m.value = c.gap;
  m.turn = slopeAlong(c, at, s.tangentAt(along), s.spin());
  nearest_.take(std::abs(m.value), at);
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
  startedOff_ = startedAt_ && std::abs(m.value) > tolerance::sameSide;
  now_.outside = m.field;
  now_.positive = m.value > 0.0;
  now_.startedRemote = now_.positive;
  nearest_ = nearestFacing_ = {};
}

std::optional<CheckWatch::Hit> CheckWatch::scan(const Segment& segment, Field& guide) {
  if (isFree(segment)) {
    pass();
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

/// Within the tolerance from the start on: the zero, farther on than that, where a tool that was
/// clear begins to violate the surface (TO), or one that violated it comes clear (PAST).
void CheckWatch::noteFirstZero(const Segment& s, double before, double u, const Measure& m) {
  const bool clear = m.value > 0.0;
  if (!startedOff_ || now_.armed || firstZero_ || nth_ != 1 || clear == now_.positive ||
      std::abs(m.value) <= tolerance::sameSide ||
      (!pointTool_ && clear != (condition_ == ir::Condition::past))) {
    return;
  }
  now_.positive = clear;
  const double at = crossing(s, before, u);
  now_.positive = !clear;
  if (at > band_) {
    firstZero_ = Hit{before, u, vanishing(m, now_.outside)};
  }
}

/// True where the measure came near zero and goes away again. A slope of zero has no direction.
bool CheckWatch::touchesHere(const Measure& m) {
  if (!now_.armed) {
    return false;  // on which side the tool was is not known before it has left the surface
  }
  const double toward = now_.positive ? m.turn : -m.turn;
  if (std::abs(toward) <= tolerance::symmetric) {
    return false;
  }
  const bool turned = near(m) && now_.bandField == m.field && now_.lastTurn < 0.0 && toward > 0.0;
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

/// Where the tool comes within its tolerance of the surface, as the position asked for, and stays
/// as near, the position is where that stretch begins: its bottom on the level face of a part,
/// which may be off by the rounding of a file.
std::optional<CheckWatch::Hit> CheckWatch::levelStretch(
    const Segment& s, double before, double u, double ahead, const Measure& m) {
  // Next to an edge of a mesh the slope is rounding.
  const bool rough = m.field->isFaceted();
  const double level = rough ? levelFacet : tolerance::symmetric;
  const auto isLevel = [&](const Measure& there) {
    return std::abs(there.turn) <= level && std::abs(there.value) <= band_;
  };
  // A point comes TO and PAST at one place.
  const int passes = !pointTool_ && toolRadius_ == 0.0 ? 2 : 1;
  const int more = wanted() - now_.seen;
  if (!now_.armed || more <= 0 || more > passes || u <= ignoredUntil_ || !(rough || isLevel(m)) ||
      (!pointTool_ && now_.positive && m.field != now_.outside) || !near(m)) {
    return std::nullopt;
  }
  const Measure behind = measure(s, u + ahead);
  if (!isLevel(behind) || (rough && !isLevel(measure(s, u + 2.0 * ahead)))) {
    return std::nullopt;
  }
  now_.free = 0.0;
  const double slope = 2.0 * std::abs(behind.turn) + tolerance::symmetric;
  return Hit{std::min(before, u - tangentStep()), u, m.field, true, now_.positive ? -slope : slope};
}

std::optional<CheckWatch::Hit> CheckWatch::scanCrossing(const Segment& s) {
  const double finest = std::max(fineShare * band_, tolerance::sameSide);
  const double finestTangent = tangentStep();
  double before = 0.0;
  double u = firstLook(s);
  for (;;) {
    const Measure m = measure(s, u);
    const double size = std::abs(m.value);
    noteFirstZero(s, before, u, m);
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
    } else if (auto hit = levelStretch(s, before, u, finest, m)) {
      return hit;
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
    const double rate = now_.armed ? m.rate : steepest(s);
    double step = rate > 0.0 ? std::max(margin / rate, finest) : tolerance::farAway;
    if (now_.armed && near(m)) {
      // A touch shows in the slope: no longer steps here, and one look at the segment's end.
      step = std::min(step, nearStep(s, finestTangent));
      step = u < s.length ? std::min(step, s.length - u) : step;
    }
    now_.nearFor = near(m) ? now_.nearFor + step : 0.0;
    before = u;
    const double farther = size - nearest();
    if (close_ && rate > 0.0) {
      step = std::min(step, std::max({closeShare * s.length, finest, farther / rate}));
    }
    u += step;
    if (u > s.length || before == s.length || isSpent()) {
      now_.free = std::max(0.0, margin - rate * (s.length - before));
      now_.farther = std::max(0.0, farther - rate * (s.length - before));
      return forFirstZero_ || s.length > endless ? firstZero_ : std::nullopt;
    }
  }
}

}  // namespace arelem::motion
