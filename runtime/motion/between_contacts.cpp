#include "runtime/motion/between_contacts.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/axis.h"
#include "runtime/motion/gap_cubic.h"

namespace arelem::motion {

namespace {
/// How often the two contacts are looked for anew with the axis found.
constexpr int roundLimit = 12;
/// How near two axes with both contacts are that count as the same one.
constexpr double sameAxis = 1e-13;
/// Next to the last share the next one is looked for in steps that grow.
constexpr double leastMargin = 1e-12, largestMargin = 0.03, growth = 16.0;
/// Where the tangents cross is known to this share of what is between them.
constexpr double leastBeyond = 1e-4;
/// From here on the contacts may be the same up to the end of the way: one look, so near to it.
constexpr double nearEnd = 0.05, endShare = 1e-6;
/// How near to each other the shares with the one and the other contact are.
constexpr double closeEnough = 1e-13;
/// Axes of shares so near to each other that differ so much jump: where the sense of the motion
/// that the normals tell turns over, no contacts change, and the way is of no use.
constexpr double besideJump = 1e-6, jumping = 1e-2;
}  // namespace

std::optional<Vec3> BetweenContacts::find(const Vec3& toolEnd, const Vec3& axis) {
  last_.share = -1.0;
  last_.here = rule_.touch(toolEnd, axis).normals();
  const auto turned = rule_.axisOf(last_.here);
  if (!turned) {
    return std::nullopt;
  }
  last_.there = rule_.touch(toolEnd, *turned).normals();
  return settle(toolEnd, {});
}

std::optional<Vec3> BetweenContacts::follow(const Vec3& toolEnd) {
  if (last_.share < 0.0) {
    return std::nullopt;
  }
  const double before = last_.share;
  const double way = (toolEnd - last_.toolEnd).norm();
  const auto bracket = around(toolEnd, last_.share, last_.rate * way);
  const auto axis = bracket ? settle(toolEnd, *bracket) : std::nullopt;
  if (axis && way > 0.0) {
    last_.rate = 2.0 * std::abs(last_.share - before) / way;
  }
  return axis;
}

/// The place of each contact changes with the axis, and the way between their normals with it.
std::optional<Vec3> BetweenContacts::settle(const Vec3& toolEnd, Bracket bracket) {
  double before = bracket.from();
  last_.share = -1.0;
  std::optional<Vec3> last;
  for (int round = 0; round < roundLimit; ++round) {
    if (!narrow(toolEnd, bracket)) {
      return std::nullopt;
    }
    const Probe found = *bracket.low;
    last_.there = found.touch.normals();
    last_.here = bracket.high->touch.normals();
    if (last && (found.axis - *last).norm() <= sameAxis) {
      last_.share = found.share;
      last_.toolEnd = toolEnd;
      return found.axis;
    }
    last = found.axis;
    const auto next = around(toolEnd, found.share, std::abs(found.share - before));
    if (!next) {
      return std::nullopt;
    }
    before = found.share;
    bracket = *next;
  }
  return std::nullopt;
}

std::optional<BetweenContacts::Probe> BetweenContacts::probe(const Vec3& toolEnd, double share) {
  const auto axis = rule_.axisOf(last_.here.towards(last_.there, share));
  if (!axis) {
    return std::nullopt;
  }
  Probe p{share, *axis, rule_.touch(toolEnd, *axis)};
  const AngleNormals n = p.touch.normals();
  p.isThere = n.from(last_.there) < n.from(last_.here);
  return p;
}

/// `margin`: how far off it may be.
std::optional<BetweenContacts::Bracket> BetweenContacts::around(const Vec3& toolEnd,
                                                                double share,
                                                                double margin) {
  Bracket bracket;
  margin = std::max(margin, leastMargin);
  auto p = probe(toolEnd, share);
  while (p) {
    bracket.take(*p);
    if (bracket.low && bracket.high) {
      return bracket;
    }
    if (p->isThere ? p->share >= 1.0 : p->share <= 0.0) {
      return std::nullopt;
    }
    margin = std::min(margin, largestMargin);
    p = probe(toolEnd, std::clamp(p->share + (p->isThere ? margin : -margin), 0.0, 1.0));
    margin *= growth;
  }
  return std::nullopt;
}

/// Each gap is that of the nearer contact: where the tangents of both cross, both touch.
double BetweenContacts::likely(const Vec3& toolEnd, const Bracket& bracket) {
  if (!bracket.low || !bracket.high) {
    return 0.5 * (bracket.from() + bracket.to());
  }
  const Probe& a = *bracket.low;
  const Probe& b = *bracket.high;
  const Vec3 turn = (b.axis - a.axis) / bracket.width();
  const auto jump = [&](tool::Contact AngleTouch::*side) {
    return ((a.touch.*side).normal - (b.touch.*side).normal).norm();
  };
  const auto side = jump(&AngleTouch::control) > jump(&AngleTouch::other) ? &AngleTouch::control
                                                                          : &AngleTouch::other;
  const auto node = [&](const Probe& p) {
    const tool::Contact& c = p.touch.*side;
    return GapNode{p.share, c.gap, changeWithAxis(c, toolEnd, p.axis).dot(turn)};
  };
  const GapNode from = node(a);
  const GapNode to = node(b);
  const double bend = from.slope - to.slope;
  const double way = bend > 0.0 ? (to.gap - from.gap - to.slope * bracket.width()) / bend : -1.0;
  return way >= 0.0 && way <= bracket.width() ? a.share + way : a.share + 0.5 * bracket.width();
}

/// Until nothing is left between both ends; false where the contacts do not change on the way, or
/// where the axis jumps.
bool BetweenContacts::narrow(const Vec3& toolEnd, Bracket& bracket) {
  const auto look = [&](double share) {
    const auto p = probe(toolEnd, share);
    if (p) {
      bracket.take(*p);
    }
    return p.has_value();
  };
  while (bracket.width() > closeEnough) {
    const double width = bracket.width();
    const bool bothKnown = bracket.low && bracket.high;
    if (bothKnown && width < besideJump &&
        (bracket.low->axis - bracket.high->axis).squaredNorm() > jumping * jumping) {
      return false;
    }
    if (!bothKnown && width < nearEnd) {
      const double end = bracket.low ? 1.0 - endShare : endShare;
      if (!look(end) || !bracket.low || !bracket.high) {
        return false;
      }
      continue;
    }
    const double at = likely(toolEnd, bracket);
    if (!look(at)) {
      return false;
    }
    // The crossing is wrong by the square of the width: a little beyond it is the other side.
    const double beyond = std::max(0.5 * width, leastBeyond) * width;
    const double next = bracket.low && bracket.low->share == at ? at + beyond : at - beyond;
    if (bothKnown && next > bracket.from() && next < bracket.to() && !look(next)) {
      return false;
    }
    if (bracket.width() > 0.5 * width && !look(0.5 * (bracket.from() + bracket.to()))) {
      return false;
    }
  }
  return bracket.low && bracket.high;
}

}  // namespace arelem::motion
