// Stops at tangencies: TANTO and PSTAN.
#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/motion/check_watch.h"
#include "runtime/motion/tilt.h"

namespace arelem::motion {

namespace {
/// Slopes of a gap at most this may be rounding: of a stretch that is touched all along.
/// Dimensionless.
constexpr double levelSlope = tolerance::symmetric;
/// Where a slope falls below that by a step at once it is at most this share of it.
constexpr double dyingShare = 0.5;
}  // namespace

/// The direction of the path. Along a chord it goes evenly from that at one end to that at the
/// other, but along a mesh from facet to facet.
Vec3 CheckWatch::wayAt(const Segment& s, double u, Field& guide) {
  const Vec3 way = s.tangentAt(u);
  if (!guide.isFaceted()) {
    return way;
  }
  const Vec3 normal = guide.at(s.at(u), s.axisAt(u)).normal;
  return withinPlane(normal, way);
}

/// What both gaps say of a tangency at one place.
CheckWatch::TangentLook CheckWatch::lookForTangency(const Segment& s, double u, Field& guide) {
  const Vec3 at = s.at(u);
  const Vec3 axis = s.axisAt(u);
  const Vec3 guideNormal = guide.at(at, axis).normal;
  TangentLook look;
  for (Field* field : {plus_.get(), minus_.get()}) {
    const tool::Contact c = field->at(at, axis);
    const bool agrees = c.normal.dot(guideNormal) > agreeing;
    const double out = std::abs(c.gap) - reach();
    (agrees ? nearestFacing_ : nearest_).take(c.gap, at);
    if (out <= 0.0) {
      look.near = true;
      if (agrees) {
        look.inside = field;
        look.turn = slopeAlong(c, at, wayAt(s, u, guide), s.spin());
      }
      continue;
    }
    const double rate = closing(s, field, c);
    look.open = std::min(look.open, rate > 0.0 ? out / rate : tolerance::farAway);
    look.free = std::min(look.free, out - rate * (s.length - u));
  }
  return look;
}

/// A contact that jumps onto a stretch where nothing opens or closes, as where a tool comes to fit
/// into a hollow, begins to touch there: the slope from which it jumps.
std::optional<double> CheckWatch::slopeBefore(const Segment& s,
                                              double u,
                                              Field& field,
                                              Field& guide) {
  const Vec3 at = s.at(u);
  const tool::Contact c = field.at(at, s.axisAt(u));
  const double slope = slopeAlong(c, at, wayAt(s, u, guide), s.spin());
  return std::abs(slope) > levelSlope ? std::optional(slope) : std::nullopt;
}

/// Whether the surface faces the tool as that faces it along which the motion goes.
bool CheckWatch::agrees(const Segment& s, double u, Field& field, Field& guide) {
  const Vec3 at = s.at(u);
  const Vec3 axis = s.axisAt(u);
  return field.at(at, axis).normal.dot(guide.at(at, axis).normal) > agreeing;
}

std::optional<CheckWatch::Hit> CheckWatch::tangency(
    const Segment& s, const TangentLook& look, double before, double u, Field& guide) {
  if (!now_.armed || u <= ignoredUntil_) {
    return std::nullopt;
  }
  if (now_.bandField == look.inside) {
    // A flat bottom touches over a whole stretch, along which only rounding gives the slope a
    // sign: the stop is where the stretch begins. A slope that dies away begins none.
    const double level = std::copysign(levelSlope, now_.lastTurn);
    const bool dies = look.turn * level > dyingShare * levelSlope * levelSlope;
    return (look.turn > level) != (now_.lastTurn > level) && !dies
               ? std::optional(
                     Hit{std::min(before, u - tangentStep()), u, look.inside, true, level})
               : std::nullopt;
  }
  if (std::abs(look.turn) > levelSlope) {
    return std::nullopt;
  }
  const double earlier = before < u ? before : u - tangentStep();
  const auto slope = slopeBefore(s, earlier, *look.inside, guide);
  return slope
             ? std::optional(Hit{earlier, u, look.inside, true, std::copysign(levelSlope, *slope)})
             : std::nullopt;
}

std::optional<CheckWatch::Hit> CheckWatch::scanTangent(const Segment& s, Field& guide) {
  const double finest = tangentStep();
  double before = 0.0;
  double u = firstLook(s);
  for (;;) {
    if (close_) {
      looks_.push_back(u);
    }
    const TangentLook look = lookForTangency(s, u, guide);
    if (look.inside != nullptr) {
      const auto hit = tangency(s, look, before, u, guide);
      now_.lastTurn = look.turn;
      if (hit) {
        now_.free = 0.0;
        return hit;
      }
      // A start at a tangency is not counted; it must be left first.
      now_.armed = now_.armed || std::abs(look.turn) > tolerance::nullDirection;
    } else {
      now_.armed = true;
      // A step may lead out of the band behind the tangency. What touches elsewhere on the tool, as
      // the far end of one that just fits into a hollow, ends none.
      const bool faces = now_.bandField && agrees(s, u, *now_.bandField, guide);
      const auto slope = faces ? slopeBefore(s, u, *now_.bandField, guide) : std::nullopt;
      if (auto hit =
              slope ? tangency(s, {now_.bandField, *slope}, before, u, guide) : std::nullopt) {
        now_.free = 0.0;
        return hit;
      }
    }
    now_.bandField = look.inside;
    before = u;
    double step = std::max(look.open, finest);
    if (close_) {
      step =
          std::min(step, std::max({finest, closeShare * s.length, closeRoots * std::sqrt(band_)}));
    }
    if (look.near) {
      step = std::min(step, nearStep(s, finest));
      step = u < s.length ? std::min(step, s.length - u) : step;
    }
    u += step;
    now_.nearFor = look.near ? now_.nearFor + step : 0.0;
    if (u > s.length || before == s.length || isSpent()) {
      now_.free = look.near ? 0.0 : std::max(0.0, look.free);
      return std::nullopt;
    }
  }
}

}  // namespace arelem::motion
